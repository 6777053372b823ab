#include "core/io/text_file.h"

#include "core/io/input_files.h"
#include "core/io/load_report.h"
#include "core/io/opened_file.h"

#include <algorithm>

namespace dirt {

std::string readBytes(const std::filesystem::path& file) {
    MemoryClaim unlimited;
    return readBytes(file, unlimited);
}

std::string readBytes(const std::filesystem::path& file, MemoryClaim& memory) {
    noteInput(file);
    return readOwnBytes(file, memory);
}

std::string readOwnBytes(const std::filesystem::path& file) {
    MemoryClaim unlimited;
    return readOwnBytes(file, unlimited);
}

std::string readOwnBytes(const std::filesystem::path& file, MemoryClaim& memory) {
    const OpenedFile opened(file);
    memory.take(opened.size(), file, "the file");
    std::string bytes;
    bytes.reserve(opened.size());
    // Of a file that grows meanwhile, what it was: no more than has been asked for.
    while (bytes.size() < opened.size()) {
        char block[1 << 16];
        const size_t wanted = std::min(sizeof block, opened.size() - bytes.size());
        const size_t count = opened.read(block, wanted);
        if (count == 0) break;
        bytes.append(block, count);
    }
    return bytes;
}

std::string_view textOf(const std::filesystem::path& file, std::string_view bytes) {
    if (bytes.starts_with("\xfe\xff") || bytes.starts_with("\xff\xfe"))
        failAt(file, 1, "is UTF-16; only ASCII and UTF-8 text can be read");
    if (bytes.starts_with("\xef\xbb\xbf")) bytes.remove_prefix(3);
    const size_t nul = bytes.find('\0');
    if (nul != std::string::npos) {
        const auto line = 1 + std::count(bytes.begin(), bytes.begin() + (ptrdiff_t) nul, '\n');
        failAt(file, (size_t) line, "holds a NUL byte: not a text file");
    }
    return bytes;
}

std::string readTextFile(const std::filesystem::path& file) {
    MemoryClaim unlimited;
    return readTextFile(file, unlimited);
}

std::string readTextFile(const std::filesystem::path& file, MemoryClaim& memory) {
    std::string text = readBytes(file, memory);
    const size_t length = textOf(file, text).size();
    text.erase(0, text.size() - length);
    return text;
}

bool LineReader::nextPhysicalLine() {
    if (rest_.empty()) return false;
    const size_t end = std::min(rest_.find_first_of("\r\n"), rest_.size());
    line_ = rest_.substr(0, end);
    size_t used = end;
    if (used < rest_.size()) used += rest_.substr(used, 2) == "\r\n" ? 2 : 1;
    rest_.remove_prefix(used);
    ++physicalNumber_;
    return true;
}

bool LineReader::next() {
    if (!nextPhysicalLine()) return false;
    number_ = physicalNumber_;
    if (continuation_ == Continuation::none || line_.empty() || line_.back() != '\\' ||
        trimmed(line_).front() == '#')
        return true;

    joined_.clear();
    for (;;) {
        const bool more = !line_.empty() && line_.back() == '\\';
        joined_ += more ? line_.substr(0, line_.size() - 1) : line_;
        if (!more) break;
        joined_ += ' ';
        if (!nextPhysicalLine()) break;
    }
    line_ = joined_;
    return true;
}

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && isBlank(text.front())) text.remove_prefix(1);
    while (!text.empty() && isBlank(text.back())) text.remove_suffix(1);
    return text;
}

std::string lowerCase(std::string text) {
    for (char& c : text)
        if (c >= 'A' && c <= 'Z') c = (char) (c - 'A' + 'a');
    return text;
}

std::string_view takeWord(std::string_view& text) {
    size_t begin = 0;
    while (begin < text.size() && isBlank(text[begin])) ++begin;
    size_t end = begin;
    while (end < text.size() && !isBlank(text[end])) ++end;
    const std::string_view word = text.substr(begin, end - begin);
    text.remove_prefix(end);
    return word;
}

bool equalButForCase(std::string_view a, std::string_view b) {
    const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? (char) (c - 'A' + 'a') : c; };
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [&](char c, char d) { return lower(c) == lower(d); });
}

} // namespace dirt
