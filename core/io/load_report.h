#pragma once

#include <cstddef>
#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace dirt {

/// What a file lacked, and a neutral stand-in replaces.
enum class WarningKind { missingMaterialLibrary, undefinedMaterial, unusableTexture };

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

/// Gathers what readers notice without stopping.
class LoadReport {
public:
    /// \p strict turns warnings into InputError.
    explicit LoadReport(bool strict = false) : strict_(strict) {}

    /// The same text is kept once.
    void warn(WarningKind kind, const std::filesystem::path& file, size_t line,
              const std::string& message);
    /// Notes a name (element, attribute, key) that has no effect; each is kept once.
    void ignore(const std::string& name);

    /// All that another report has, in its order.
    void append(const LoadReport& other);

    const std::vector<Warning>& warnings() const { return warnings_; }
    /// In the order of first appearance.
    const std::vector<std::string>& ignored() const { return ignored_; }

    /// A name as ignored() has it.
    void addIgnored(std::string text);

private:
    void add(Warning warning);

    bool strict_;
    std::vector<Warning> warnings_;
    std::vector<std::string> ignored_;
    std::set<std::string> seenWarnings_, seenNames_;
};

} // namespace dirt
