#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace dirt {

/// What a file lacked, and a neutral stand-in replaces.
enum class WarningKind {
    missingMaterialLibrary,
    undefinedMaterial,
    unusableTexture,
    unusableAttribute, ///< of a corner or vertex: a normal, texture coordinates, a colour
    skippedGeometry,   ///< a face or a vertex that cannot be
    precision,         ///< float32 does not hold what the files say
    unusableValue,     ///< of a material: a number that cannot be
    unseenMaterial     ///< a surface so transparent that it is taken as not there
};
inline constexpr WarningKind kLastWarningKind = WarningKind::unseenMaterial;

/// Something that did not stop the load. The text is one line, "file:line: what is missing".
struct Warning {
    WarningKind kind;
    std::string text;
};

/// \p text on one line and in valid UTF-8: what is neither becomes '?'. At most 200 bytes are kept.
std::string printable(std::string_view text);

/// 'text', printable.
std::string inQuotes(std::string_view text);

/// "file:line: message"; without the line where it is 0.
std::string atLine(const std::filesystem::path& file, size_t line, const std::string& message);

/// Throws InputError with atLine's text.
[[noreturn]] void failAt(const std::filesystem::path& file, size_t line,
                         const std::string& message);

/// A kind of fault in one file, however often it is there.
struct Fault {
    WarningKind kind;
    size_t line;         ///< of the first; 0: the file has no lines
    std::string message; ///< what is wrong with the first, and what stands in for all
    uint64_t count;
};

/// Counts the faults of one file, of which there may be a million.
class FaultCounter {
public:
    /// \p name tells faults of one kind and is not shown. Of each name the first message() counts;
    /// it is not called again.
    template <typename Message>
    void add(WarningKind kind, std::string_view name, size_t line, const Message& message) {
        const auto known = places_.find(name);
        if (known != places_.end()) {
            ++faults_[known->second].count;
            return;
        }
        places_.emplace(name, faults_.size());
        faults_.push_back({kind, line, message(), 1});
    }

    /// In the order of their first appearance.
    const std::vector<Fault>& faults() const { return faults_; }

private:
    std::vector<Fault> faults_;
    std::map<std::string, size_t, std::less<>> places_;
};

/// Gathers what readers notice without stopping.
class LoadReport {
public:
    /// \p strict turns warnings into InputError.
    explicit LoadReport(bool strict = false) : strict_(strict) {}

    /// The same text is kept once.
    void warn(WarningKind kind, const std::filesystem::path& file, size_t line,
              const std::string& message);
    /// One warning for each, with how often it is there.
    void warn(const std::filesystem::path& file, const std::vector<Fault>& faults);
    /// Notes a name (element, attribute, key) that has no effect; each is kept once.
    void ignore(const std::string& name);

    /// Notes a cache of a model that was written.
    void keptCache(const std::filesystem::path& file);

    /// All that another report has, in its order.
    void append(const LoadReport& other);

    const std::vector<Warning>& warnings() const { return warnings_; }
    /// In the order of first appearance.
    const std::vector<std::string>& ignored() const { return ignored_; }
    /// Printable names of the caches that were written.
    const std::vector<std::string>& caches() const { return caches_; }

    /// A name as ignored() has it.
    void addIgnored(std::string text);

private:
    void add(Warning warning);

    bool strict_;
    std::vector<Warning> warnings_;
    std::vector<std::string> ignored_, caches_;
    std::set<std::string> seenWarnings_, seenNames_;
};

} // namespace dirt
