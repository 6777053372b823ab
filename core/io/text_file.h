#pragma once

#include "core/io/memory_budget.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace dirt {

/// The bytes of a file, which is noted as an input. Throws InputError where it cannot be read.
std::string readBytes(const std::filesystem::path& file);

/// The same; \p memory takes what they need.
std::string readBytes(const std::filesystem::path& file, MemoryClaim& memory);

/// The same for a file that the program keeps for itself, and may write again: it is not noted.
std::string readOwnBytes(const std::filesystem::path& file);
std::string readOwnBytes(const std::filesystem::path& file, MemoryClaim& memory);

/// \p bytes, which \p file holds, without a UTF-8 byte order mark. Throws InputError where they are
/// UTF-16 or hold NUL bytes.
std::string_view textOf(const std::filesystem::path& file, std::string_view bytes);

/// The bytes of a text file, without a UTF-8 byte order mark. Throws InputError where the file
/// cannot be read, is UTF-16 or holds NUL bytes.
std::string readTextFile(const std::filesystem::path& file);
std::string readTextFile(const std::filesystem::path& file, MemoryClaim& memory);

/// Hands out the lines of a text. Lines end in LF, CR LF or CR; the last one need not end.
class LineReader {
public:
    enum class Continuation { none, backslash };

    /// With Continuation::backslash a line that ends in a backslash goes on in the next one (a
    /// blank takes the backslash's place); comments, which begin with '#', do not.
    explicit LineReader(std::string_view text, Continuation continuation = Continuation::none)
        : rest_(text), continuation_(continuation) {}

    /// Moves to the next line; false at the end.
    bool next();
    /// Without its line ending. Valid until next() is called again.
    std::string_view line() const { return line_; }
    /// Number of the line, or of the first of those that were joined; the first line is 1.
    size_t number() const { return number_; }

private:
    bool nextPhysicalLine();

    std::string_view rest_;
    Continuation continuation_;
    std::string_view line_;
    std::string joined_;
    size_t number_ = 0;
    size_t physicalNumber_ = 0;
};

/// Whether \p c separates words on a line.
constexpr bool isBlank(char c) {
    return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

/// \p text without blanks at either end.
std::string_view trimmed(std::string_view text);

/// With small letters for the capital ones of ASCII.
std::string lowerCase(std::string text);

/// Takes the next word, up to a blank, off the front of \p text; empty where none is left.
std::string_view takeWord(std::string_view& text);

/// Whether two texts are the same but for the case of ASCII letters.
bool equalButForCase(std::string_view a, std::string_view b);

} // namespace dirt
