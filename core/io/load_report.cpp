#include "core/io/load_report.h"

#include "core/base/error.h"
#include "core/io/utf8.h"

namespace dirt {

std::string printable(std::string_view text) {
    constexpr size_t kLongest = 200;
    std::string out;
    for (size_t i = 0; i < text.size();) {
        const size_t length = utf8Length(text.substr(i));
        const bool control = length == 1 && ((unsigned char) text[i] < 0x20 || text[i] == 0x7f);
        const std::string_view piece =
            length == 0 || control ? std::string_view("?") : text.substr(i, length);
        if (out.size() + piece.size() > kLongest) return out + "...";
        out += piece;
        i += length == 0 ? 1 : length;
    }
    return out;
}

std::string inQuotes(std::string_view text) {
    std::string out = "'";
    return out.append(printable(text)).append("'");
}

std::string atLine(const std::filesystem::path& file, size_t line, const std::string& message) {
    std::string place = printable(file.string());
    if (line > 0) place.append(":").append(std::to_string(line));
    return place.append(": ").append(message);
}

void failAt(const std::filesystem::path& file, size_t line, const std::string& message) {
    throw InputError(atLine(file, line, message));
}

void LoadReport::warn(WarningKind kind, const std::filesystem::path& file, size_t line,
                      const std::string& message) {
    add({kind, atLine(file, line, message)});
}

void LoadReport::warn(const std::filesystem::path& file, const std::vector<Fault>& faults) {
    for (const Fault& fault : faults) {
        const std::string times =
            fault.count > 1 ? " (" + std::to_string(fault.count) + " times)" : "";
        warn(fault.kind, file, fault.line, fault.message + times);
    }
}

void LoadReport::ignore(const std::string& name) {
    addIgnored(printable(name));
}

void LoadReport::keptCache(const std::filesystem::path& file) {
    caches_.push_back(printable(file.string()));
}

void LoadReport::append(const LoadReport& other) {
    caches_.insert(caches_.end(), other.caches_.begin(), other.caches_.end());
    for (const Warning& warning : other.warnings_) add(warning);
    for (const std::string& text : other.ignored_) addIgnored(text);
}

void LoadReport::add(Warning warning) {
    if (strict_) throw InputError(warning.text);
    if (seenWarnings_.insert(warning.text).second) warnings_.push_back(std::move(warning));
}

void LoadReport::addIgnored(std::string text) {
    if (seenNames_.insert(text).second) ignored_.push_back(std::move(text));
}

} // namespace dirt
