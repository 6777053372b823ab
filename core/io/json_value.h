#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp> // json.hpp takes longer to compile than what uses a JsonValue

namespace dirt {

/// A value in a JSON file that knows its place, for errors such as
/// "file: meshes[3].primitives[0].mode is not a whole number from 0 to 6". Getters of members
/// return nothing where the member is absent, and throw InputError where it is of another kind.
/// The document must outlive it.
class JsonValue {
public:
    /// The root.
    JsonValue(const std::filesystem::path& file, const nlohmann::json& value)
        : file_(&file), value_(&value) {}

    bool isObject() const;
    bool has(const char* name) const;
    /// An object's member; throws InputError where it is absent.
    JsonValue required(const char* name) const;
    /// A member that is an object.
    std::optional<JsonValue> object(const char* name) const;
    /// The elements of a member that is an array, each of them an object; none where it is absent.
    std::vector<JsonValue> objects(const char* name) const;
    /// One of these; throws InputError where there are not so many. \p from says what refers to it.
    static const JsonValue& at(const std::vector<JsonValue>& list, uint64_t index,
                               const JsonValue& from, const char* name);

    /// What 32 bits number; the last number stands for none.
    static constexpr uint64_t kMostIndex = 0xfffffffe;
    /// What a double holds exactly.
    static constexpr uint64_t kMostInteger = uint64_t(1) << 53;

    std::optional<uint64_t> integer(const char* name, uint64_t highest) const;
    uint64_t requiredInteger(const char* name, uint64_t highest) const;
    std::optional<double> number(const char* name, double lowest, double highest) const;
    std::optional<bool> boolean(const char* name) const;
    std::optional<std::string> text(const char* name) const;
    /// Exactly \p count finite numbers.
    std::optional<std::vector<double>> numbers(const char* name, size_t count) const;
    /// Any count of whole numbers.
    std::vector<uint64_t> integers(const char* name, uint64_t highest) const;
    /// The names of the object's members.
    std::vector<std::string> names() const;

    const std::filesystem::path& file() const { return *file_; }
    /// As errors name it: "meshes[3].primitives[0]"; empty for the root.
    const std::string& place() const { return place_; }

    /// Throws InputError: "file: place message".
    [[noreturn]] void fail(const std::string& message) const;

private:
    JsonValue(const JsonValue& parent, const nlohmann::json& value, std::string place)
        : file_(parent.file_), value_(&value), place_(std::move(place)) {}
    std::optional<JsonValue> member(const char* name) const;

    const std::filesystem::path* file_;
    const nlohmann::json* value_;
    std::string place_; ///< empty for the root
};

/// Bytes that parseJson of \p text takes at most, or nearly so.
uint64_t jsonBytes(std::string_view text);

/// A parsed file. The library's own type takes memory to go, and ends the process where there is
/// none; this does not.
struct JsonDeleter {
    void operator()(nlohmann::json* document) const;
};
using JsonDocument = std::unique_ptr<nlohmann::json, JsonDeleter>;

/// Parses \p text of \p file. Throws InputError, with the line where \p hasLines says that the file
/// is that text.
nlohmann::json parseJson(const std::filesystem::path& file, std::string_view text, bool hasLines);

} // namespace dirt
