#pragma once

#include <bit>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace dirt {

/// A column of a buffer: a number, or a word (an unsigned integer of 32 bits).
struct Column {
    enum class Kind { number, word, optionalWord };
    std::string name;
    Kind kind = Kind::number;
};

/// Records of a dumped buffer, from a text file or from a part of an EXR file.
struct Table {
    std::filesystem::path file;
    std::string part; ///< of an EXR file with several
    int width = 0;    ///< of the EXR picture; 0: the file is text
    size_t rows = 0, columns = 0;
    std::vector<bool> has;        ///< by column: whether the file has it
    std::vector<uint32_t> values; ///< bits, row after row, in the order of the columns asked for

    float number(size_t row, size_t column) const {
        return std::bit_cast<float>(values[row * columns + column]);
    }
    uint32_t word(size_t row, size_t column) const { return values[row * columns + column]; }

    /// Throws InputError: file, line or pixel of \p row, \p message.
    [[noreturn]] void fail(size_t row, const std::string& message) const;
    /// The same of the file as a whole.
    [[noreturn]] void fail(const std::string& message) const;
};

/// Reads FILE.csv (a line of names, then a line a record with commas between) or the parts of
/// FILE.exr (the pixels row by row; channels NAME.X and NAME.Z are columns NAME). Numbers are
/// finite, decimal or hexadecimal; denormals become zeros, as everywhere in the grid. Columns that
/// are neither asked for nor \p known without effect are added to \p ignored as "file: column
/// NAME". Throws InputError where a column is missing or a value is not of its kind.
std::vector<Table> readTables(const std::filesystem::path& file, const std::vector<Column>& columns,
                              const std::vector<std::string>& known,
                              std::vector<std::string>& ignored);

} // namespace dirt
