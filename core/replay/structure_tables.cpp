#include "core/replay/structure_tables.h"

#include "core/base/error.h"
#include "core/io/load_report.h"
#include "core/replay/table.h"

#include <algorithm>

namespace dirt {

namespace {

using Kind = Column::Kind;

/// Pyramids of the right sizes, and which of their cells have been read.
struct Pyramids {
    std::vector<DepthPyramid> pyramids;
    std::vector<std::vector<std::vector<bool>>> read;

    explicit Pyramids(const std::vector<View>& views) {
        for (const View& view : views) {
            auto& levels = pyramids.emplace_back().levels;
            auto& marks = read.emplace_back();
            for (int columns = view.columns, rows = view.rows;;
                 columns = (columns + 1) / 2, rows = (rows + 1) / 2) {
                const size_t cells = (size_t) columns * (size_t) rows;
                levels.push_back({columns, rows, std::vector<DepthBounds>(cells)});
                marks.emplace_back(cells, false);
                if (cells == 1) break;
            }
        }
    }

    void set(const Table& table, size_t row, uint32_t view, uint32_t level, size_t cell, float near,
             float far) {
        if (read[view][level][cell]) table.fail(row, "is there a second time");
        read[view][level][cell] = true;
        if (near <= far) pyramids[view].levels[level].bounds[cell] = {near, far};
    }

    /// Whether all cells of a level are there, or (false) none.
    bool isWhole(const std::filesystem::path& file, const std::string& view, size_t level,
                 const std::vector<bool>& marks) const {
        const auto missing = std::find(marks.begin(), marks.end(), false);
        if (missing == marks.end()) return true;
        if (level > 0 && std::find(marks.begin(), marks.end(), true) == marks.end()) return false;
        const size_t columns = (size_t) pyramids[0].levels[level].columns;
        const auto cell = (size_t) (missing - marks.begin());
        failAt(file, 0,
               "lacks view " + printable(view) + ", level " + std::to_string(level) + ", column " +
                   std::to_string(cell % columns) + ", row " + std::to_string(cell / columns));
    }
};

/// \p value below \p end.
uint32_t below(const Table& table, size_t row, size_t column, const char* name, size_t end) {
    const uint32_t value = table.word(row, column);
    if (value >= end)
        table.fail(row, std::string(name) + " is " + std::to_string(value) + ", where there are " +
                            std::to_string(end));
    return value;
}

const std::vector<Column> kBounds = {{"near", Kind::number}, {"far", Kind::number}};

void readText(const Table& table, Pyramids& pyramids) {
    for (size_t row = 0; row < table.rows; ++row) {
        const uint32_t view = below(table, row, 0, "view", pyramids.pyramids.size());
        const auto& levels = pyramids.pyramids[view].levels;
        const uint32_t level = below(table, row, 1, "level", levels.size());
        const DepthPyramid::Level& cells = levels[level];
        const uint32_t x = below(table, row, 2, "column", (size_t) cells.columns);
        const uint32_t y = below(table, row, 3, "row", (size_t) cells.rows);
        pyramids.set(table, row, view, level, (size_t) y * (size_t) cells.columns + x,
                     table.number(row, 4), table.number(row, 5));
    }
}

/// A part for each view and level, "NAME.levelL".
void readPart(const Table& table, const std::vector<std::string>& names, Pyramids& pyramids) {
    for (uint32_t view = 0; view < names.size(); ++view)
        for (uint32_t level = 0; level < pyramids.pyramids[view].levels.size(); ++level) {
            if (table.part != names[view] + ".level" + std::to_string(level)) continue;
            const DepthPyramid::Level& cells = pyramids.pyramids[view].levels[level];
            if (table.width != cells.columns || table.rows != cells.bounds.size())
                table.fail("has not " + std::to_string(cells.columns) + "x" +
                           std::to_string(cells.rows) + " pixels");
            for (size_t cell = 0; cell < table.rows; ++cell)
                pyramids.set(table, cell, view, level, cell, table.number(cell, 0),
                             table.number(cell, 1));
            return;
        }
    table.fail("is of no view and level that there is");
}

/// Throws InputError before memory is taken for cells that the file does not have.
void checkCells(const std::filesystem::path& file, const std::vector<Table>& tables,
                const std::vector<View>& views, int bins) {
    size_t rows = 0, tiles = 0;
    for (const Table& table : tables) rows += table.rows;
    for (const View& view : views) tiles += (size_t) view.tiles();
    if (rows < tiles)
        failAt(file, 0,
               "has " + std::to_string(rows) + " records, where the views have " +
                   std::to_string(tiles) + " tiles");
    if (tiles * (size_t) bins > kMaxCells)
        failAt(file, 0, "has more than " + std::to_string(kMaxCells) + " bins in all");
}

} // namespace

Grid readDepth(const std::filesystem::path& file, ReplayInput& input, bool& hasPyramid) {
    const Manifest& manifest = input.manifest;
    const bool isText = file.extension() == ".csv";
    std::vector<Column> columns = kBounds;
    if (isText)
        columns.insert(columns.begin(), {{"view", Kind::word},
                                         {"level", Kind::word},
                                         {"column", Kind::word},
                                         {"row", Kind::word}});
    const std::vector<Table> tables = readTables(file, columns, {}, input.ignored);
    checkCells(file, tables, manifest.views, manifest.settings.bins);
    Pyramids read(manifest.views);
    for (const Table& table : tables)
        if (isText)
            readText(table, read);
        else
            readPart(table, manifest.viewNames, read);

    size_t above = 0, whole = 0;
    for (size_t view = 0; view < manifest.views.size(); ++view)
        for (size_t level = 0; level < read.read[view].size(); ++level) {
            const bool isWhole =
                read.isWhole(file, manifest.viewNames[view], level, read.read[view][level]);
            above += level > 0;
            whole += level > 0 && isWhole;
        }
    if (whole != 0 && whole != above)
        failAt(file, 0, "lacks levels of the pyramid: all or none above level 0 are dumped");
    hasPyramid = whole > 0;

    Grid grid;
    grid.settings = manifest.settings;
    grid.views = manifest.views;
    grid.pyramids = std::move(read.pyramids);
    if (!hasPyramid)
        for (DepthPyramid& pyramid : grid.pyramids) buildPyramid(pyramid);
    uint32_t tiles = 0;
    for (const View& view : grid.views) {
        grid.firstTile.push_back(tiles);
        tiles += (uint32_t) view.tiles();
    }
    grid.firstTile.push_back(tiles);
    return grid;
}

std::vector<DumpedEntry> readEntries(const std::filesystem::path& file, ReplayInput& input) {
    if (file.extension() == ".exr")
        failAt(file, 0,
               "lists are read from text: ids.csv, as dirt dump writes it beside the deep "
               "EXR file");
    const std::vector<Table> tables = readTables(file,
                                                 {{"view", Kind::word},
                                                  {"column", Kind::word},
                                                  {"row", Kind::word},
                                                  {"bin", Kind::word},
                                                  {"id", Kind::word}},
                                                 {}, input.ignored);
    const Table& table = tables.front();
    const std::vector<View>& views = input.manifest.views;
    std::vector<DumpedEntry> entries(table.rows);
    for (size_t row = 0; row < table.rows; ++row) {
        DumpedEntry& entry = entries[row];
        entry.view = below(table, row, 0, "view", views.size());
        const View& view = views[entry.view];
        const uint32_t x = below(table, row, 1, "column", (size_t) view.columns);
        const uint32_t y = below(table, row, 2, "row", (size_t) view.rows);
        entry.tile = y * (uint32_t) view.columns + x;
        entry.bin = below(table, row, 3, "bin", (size_t) input.manifest.settings.bins);
        entry.id = below(table, row, 4, "id", input.geometry.triangles.size());
    }
    checkEntryCount(entries.size());
    std::sort(entries.begin(), entries.end());
    return entries;
}

void fillLists(const std::vector<DumpedEntry>& entries, Grid& grid) {
    const size_t cells = (size_t) grid.firstTile.back() * (size_t) grid.settings.bins;
    grid.heads.assign(cells + 1, 0);
    const DumpedEntry* last = nullptr;
    for (const DumpedEntry& entry : entries) {
        if (last && *last == entry) continue;
        last = &entry;
        grid.ids.push_back(entry.id);
        ++grid.heads[grid.cell((int) entry.view, (int) entry.tile, (int) entry.bin) + 1];
    }
    for (size_t c = 1; c <= cells; ++c) grid.heads[c] += grid.heads[c - 1];
}

} // namespace dirt
