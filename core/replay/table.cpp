#include "core/replay/table.h"

#include "core/io/load_report.h"
#include "core/io/read_exr_parts.h"
#include "core/io/text_file.h"
#include "shaders/shared/rounding.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

namespace dirt {

namespace {

constexpr size_t kAbsent = SIZE_MAX;

/// More no buffer has, nor an engine's additions to one.
constexpr size_t kMaxColumns = 1000;

/// For each of \p columns its place among the \p names of a file.
std::vector<size_t> placesOf(const std::vector<Column>& columns,
                             const std::vector<std::string>& names,
                             const std::vector<std::string>& known, const Table& table,
                             std::vector<std::string>& ignored) {
    if (names.size() > kMaxColumns)
        table.fail("has more than " + std::to_string(kMaxColumns) + " columns");
    for (size_t i = 0; i < names.size(); ++i) {
        if (std::find(names.begin(), names.begin() + (ptrdiff_t) i, names[i]) !=
            names.begin() + (ptrdiff_t) i)
            table.fail("has two columns " + inQuotes(names[i]));
        const bool asked = std::any_of(columns.begin(), columns.end(),
                                       [&](const Column& c) { return c.name == names[i]; });
        if (asked || std::find(known.begin(), known.end(), names[i]) != known.end()) continue;
        const std::string text = table.file.filename().string() + ": column " + printable(names[i]);
        if (std::find(ignored.begin(), ignored.end(), text) == ignored.end())
            ignored.push_back(text);
    }
    std::vector<size_t> places;
    for (const Column& column : columns) {
        const auto at = std::find(names.begin(), names.end(), column.name);
        if (at == names.end() && column.kind != Column::Kind::optionalWord)
            table.fail("has no column " + column.name);
        places.push_back(at == names.end() ? kAbsent : (size_t) (at - names.begin()));
    }
    return places;
}

Table emptyTable(const std::filesystem::path& file, const std::vector<Column>& columns) {
    Table table;
    table.file = file;
    table.columns = columns.size();
    return table;
}

void noteColumns(const std::vector<size_t>& places, Table& table) {
    for (const size_t place : places) table.has.push_back(place != kAbsent);
}

/// As the grid has it.
uint32_t bitsOf(float value) {
    return std::bit_cast<uint32_t>(flushed(value));
}

/// All of \p text as a float: decimal, or hexadecimal after "0x".
std::optional<float> parseFloat(std::string_view text) {
    const bool negative = text.starts_with('-');
    if (negative || text.starts_with('+')) text.remove_prefix(1);
    const bool hex = text.starts_with("0x") || text.starts_with("0X");
    if (hex) text.remove_prefix(2);
    // No second sign.
    if (text.empty() || text.front() == '-' || text.front() == '+') return std::nullopt;
    float value = 0.0f;
    const auto [stop, error] =
        std::from_chars(text.data(), text.data() + text.size(), value,
                        hex ? std::chars_format::hex : std::chars_format::general);
    if (stop != text.data() + text.size() || error == std::errc::invalid_argument)
        return std::nullopt;
    // Too large, or so small that it is zero: the double tells which.
    if (error == std::errc::result_out_of_range) {
        double wide = 0.0;
        const auto again =
            std::from_chars(text.data(), text.data() + text.size(), wide,
                            hex ? std::chars_format::hex : std::chars_format::general);
        if (again.ec != std::errc() || std::fabs(wide) > 1.0) return std::nullopt;
        value = 0.0f;
    }
    return negative ? -value : value;
}

uint32_t parseCell(const Table& table, const Column& column, std::string_view text) {
    if (column.kind == Column::Kind::number) {
        const auto value = parseFloat(text);
        if (!value || !std::isfinite(*value))
            table.fail(table.rows, column.name + " is " + inQuotes(text) + ", no finite float");
        return bitsOf(*value);
    }
    uint32_t value = 0;
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (stop != text.data() + text.size() || error != std::errc())
        table.fail(table.rows, column.name + " is " + inQuotes(text) +
                                   ", no whole number from 0 to 4294967295");
    return value;
}

std::vector<std::string_view> cellsOf(std::string_view line) {
    std::vector<std::string_view> cells;
    for (;;) {
        const size_t comma = std::min(line.find(','), line.size());
        cells.push_back(trimmed(line.substr(0, comma)));
        if (comma == line.size()) return cells;
        line.remove_prefix(comma + 1);
    }
}

Table readText(const std::filesystem::path& file, const std::vector<Column>& columns,
               const std::vector<std::string>& known, std::vector<std::string>& ignored) {
    Table table = emptyTable(file, columns);
    const std::string text = readTextFile(file);
    LineReader lines(text);
    if (!lines.next()) table.fail("has no line of column names");
    const std::vector<std::string_view> header = cellsOf(lines.line());
    const std::vector<std::string> names(header.begin(), header.end());
    const std::vector<size_t> places = placesOf(columns, names, known, table, ignored);
    noteColumns(places, table);
    while (lines.next()) {
        const std::vector<std::string_view> cells = cellsOf(lines.line());
        if (cells.size() != names.size())
            table.fail(table.rows, "has " + std::to_string(cells.size()) + " values, not " +
                                       std::to_string(names.size()));
        for (size_t c = 0; c < columns.size(); ++c)
            table.values.push_back(
                places[c] == kAbsent ? 0 : parseCell(table, columns[c], cells[places[c]]));
        ++table.rows;
    }
    return table;
}

/// The column that a channel is: of NAME.X or NAME.Z, as EXR files call a single number, NAME.
/// Those of vectors are columns themselves.
std::string columnOf(const std::string& channel, const std::vector<Column>& columns,
                     const std::vector<std::string>& known) {
    if (!channel.ends_with(".X") && !channel.ends_with(".Z")) return channel;
    const std::string name = channel.substr(0, channel.size() - 2);
    const bool isNumber = std::find(known.begin(), known.end(), name) != known.end() ||
                          std::any_of(columns.begin(), columns.end(),
                                      [&](const Column& c) { return c.name == name; });
    return isNumber ? name : channel;
}

Table tableOf(const std::filesystem::path& file, ExrPart& part, const std::vector<Column>& columns,
              const std::vector<std::string>& known, std::vector<std::string>& ignored) {
    Table table = emptyTable(file, columns);
    table.part = part.name;
    table.width = part.width;
    table.rows = (size_t) part.width * (size_t) part.height;
    std::vector<std::string> names;
    for (const ExrChannel& channel : part.channels)
        names.push_back(columnOf(channel.name, columns, known));
    const std::vector<size_t> places = placesOf(columns, names, known, table, ignored);
    noteColumns(places, table);
    for (size_t c = 0; c < columns.size(); ++c) {
        if (places[c] == kAbsent) continue;
        const bool isNumber = part.channels[places[c]].type == ExrChannel::Type::float32;
        if (isNumber != (columns[c].kind == Column::Kind::number))
            table.fail("channel " + columns[c].name + " has " +
                       (isNumber ? "floats, not unsigned integers" : "integers, not floats"));
    }
    table.values.resize(table.rows * columns.size(), 0);
    for (size_t row = 0; row < table.rows; ++row)
        for (size_t c = 0; c < columns.size(); ++c) {
            if (places[c] == kAbsent) continue;
            uint32_t bits = part.values[row * names.size() + places[c]];
            if (columns[c].kind == Column::Kind::number) {
                if (!std::isfinite(std::bit_cast<float>(bits)))
                    table.fail(row, columns[c].name + " is not finite");
                bits = bitsOf(std::bit_cast<float>(bits));
            }
            table.values[row * columns.size() + c] = bits;
        }
    part.values = {};
    return table;
}

} // namespace

void Table::fail(size_t row, const std::string& message) const {
    if (width == 0) failAt(file, row + 2, message); // below the names
    failAt(file, 0,
           (part.empty() ? "" : printable(part) + ", ") + "pixel " +
               std::to_string(row % (size_t) width) + "," + std::to_string(row / (size_t) width) +
               ": " + message);
}

void Table::fail(const std::string& message) const {
    failAt(file, width == 0 ? 1 : 0, (part.empty() ? "" : printable(part) + ": ") + message);
}

std::vector<Table> readTables(const std::filesystem::path& file, const std::vector<Column>& columns,
                              const std::vector<std::string>& known,
                              std::vector<std::string>& ignored) {
    std::vector<Table> tables;
    if (file.extension() == ".csv") {
        tables.push_back(readText(file, columns, known, ignored));
    } else if (file.extension() == ".exr") {
        for (ExrPart& part : readExrParts(file))
            tables.push_back(tableOf(file, part, columns, known, ignored));
    } else {
        failAt(file, 0, "is neither a .csv nor an .exr file");
    }
    return tables;
}

} // namespace dirt
