#include "core/replay/replay_input.h"

#include "core/io/load_report.h"
#include "core/replay/structure_tables.h"
#include "core/replay/table.h"
#include "core/trace/intersect.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dirt {

namespace {

using Kind = Column::Kind;

/// Reads the one table of a buffer.
Table readOne(const ManifestFile& file, const std::vector<Column>& columns,
              const std::vector<std::string>& known, std::vector<std::string>& ignored) {
    std::vector<Table> tables = readTables(file.file, columns, known, ignored);
    if (tables.size() != 1)
        failAt(file.file, 0, "has " + std::to_string(tables.size()) + " parts, not one");
    return std::move(tables.front());
}

/// Corners within the grid frame: its scale is part of what margins are derived for.
void checkScale(const Table& table, const std::vector<Triangle>& triangles) {
    float largest = 0.0f;
    for (const Triangle& triangle : triangles)
        for (const glm::vec3& corner : {triangle.a, triangle.b, triangle.c})
            for (int i = 0; i < 3; ++i) largest = std::max(largest, std::fabs(corner[i]));
    if (largest == 0.0f || (largest >= 1.0f && largest < 2.0f)) return;
    failAt(table.file, 0,
           "the largest coordinate is not in [1, 2), as in the grid frame: multiply all lengths by "
           "2^" +
               std::to_string(-std::ilogb(largest)));
}

std::vector<Triangle> readTriangles(const ManifestFile& file, const Manifest& manifest,
                                    std::vector<std::string>& ignored) {
    std::vector<Column> columns;
    for (const char* corner : {"a", "b", "c"})
        for (const char* axis : {".X", ".Y", ".Z"})
            columns.push_back({std::string(corner) + axis, Kind::number});
    const Table table = readOne(file, columns, {}, ignored);
    const size_t count = manifest.triangles.value_or(table.rows);
    // The last row of a picture may be filled up.
    const bool fits = table.width == 0
                          ? count == table.rows
                          : count <= table.rows && table.rows - count < (size_t) table.width;
    if (!fits)
        failAt(table.file, 0,
               "has " + std::to_string(table.rows) + " triangles, where the manifest has " +
                   std::to_string(count));
    if (count == 0) failAt(table.file, 0, "has no triangles");
    if (count >= kNoPrimitive) failAt(table.file, 0, "has more triangles than ids");
    std::vector<Triangle> triangles(count);
    for (size_t id = 0; id < count; ++id)
        for (int i = 0; i < 9; ++i) (&triangles[id].a)[i / 3][i % 3] = table.number(id, (size_t) i);
    checkScale(table, triangles);
    return triangles;
}

void checkPixels(const Table& table, const GridSettings& settings) {
    const size_t pixels = (size_t) settings.width * (size_t) settings.height;
    if (table.rows != pixels || (table.width != 0 && table.width != settings.width))
        failAt(table.file, 0,
               "has " + std::to_string(table.rows) + " records, not one for each of " +
                   std::to_string(settings.width) + "x" + std::to_string(settings.height) +
                   " pixels");
}

std::vector<Ray> readRays(const ManifestFile& file, const ReplayInput& input,
                          std::vector<std::string>& ignored) {
    const std::vector<Column> columns = {
        {"origin.X", Kind::number},    {"origin.Y", Kind::number},    {"origin.Z", Kind::number},
        {"direction.X", Kind::number}, {"direction.Y", Kind::number}, {"direction.Z", Kind::number},
        {"skip", Kind::optionalWord}};
    const Table table =
        readOne(file, columns, {"pdf", "throughput.R", "throughput.G", "throughput.B"}, ignored);
    checkPixels(table, input.manifest.settings);
    std::vector<Ray> rays(table.rows);
    for (size_t row = 0; row < table.rows; ++row) {
        Ray& ray = rays[row];
        for (size_t i = 0; i < 3; ++i) {
            ray.origin[(int) i] = table.number(row, i);
            ray.direction[(int) i] = table.number(row, 3 + i);
        }
        if (table.has[6]) ray.skip = table.word(row, 6);
        if (ray.skip != kNoPrimitive && ray.skip >= input.geometry.triangles.size())
            table.fail(row, "skip is " + std::to_string(ray.skip) + ", where there are " +
                                std::to_string(input.geometry.triangles.size()) + " triangles");
    }
    return rays;
}

/// The view and tile of a record, where there are views to be in.
void checkTile(const Table& table, size_t row, const Hit& hit, const std::vector<View>& views) {
    if (hit.view > views.size())
        table.fail(row, "view is " + std::to_string(hit.view) + ", where there are " +
                            std::to_string(views.size()));
    if (hit.view < views.size() && hit.tile >= (uint32_t) views[hit.view].tiles())
        table.fail(row, "tile is " + std::to_string(hit.tile) + ", where the view has " +
                            std::to_string(views[hit.view].tiles()));
}

void readHits(const ManifestFile& file, const ReplayInput& input, DumpedHits& event,
              std::vector<std::string>& ignored) {
    const std::vector<Column> columns = {
        {"primitive", Kind::word}, {"t", Kind::number},          {"u", Kind::number},
        {"v", Kind::number},       {"view", Kind::optionalWord}, {"tile", Kind::optionalWord}};
    const Table table = readOne(file, columns, {"fetches"}, ignored);
    checkPixels(table, input.manifest.settings);
    if (table.has[4] != table.has[5]) table.fail("has one of the columns view and tile");
    event.filed = table.has[4] && !input.manifest.views.empty();
    event.hits.resize(table.rows);
    for (size_t row = 0; row < table.rows; ++row) {
        Hit& hit = event.hits[row];
        hit.primitive = table.word(row, 0);
        hit.t = table.number(row, 1);
        hit.u = table.number(row, 2);
        hit.v = table.number(row, 3);
        hit.view = table.word(row, 4);
        hit.tile = table.word(row, 5);
        if (!hit.found()) continue;
        if (hit.primitive >= input.geometry.triangles.size())
            table.fail(row, "primitive is " + std::to_string(hit.primitive) + ", where there are " +
                                std::to_string(input.geometry.triangles.size()) + " triangles");
        if (event.filed) checkTile(table, row, hit, input.manifest.views);
    }
}

/// The file of a buffer (and event); null where there is none. Of ids the text, which a dump has
/// beside the deep EXR file with the same entries.
const ManifestFile* find(const Manifest& manifest, const std::string& buffer,
                         std::optional<int> event = {}) {
    const ManifestFile* found = nullptr;
    const auto isDeep = [](const ManifestFile& file) { return file.file.extension() == ".exr"; };
    for (const ManifestFile& file : manifest.files) {
        if (file.buffer != buffer || file.event != event) continue;
        if (found && (buffer != "ids" || isDeep(*found) == isDeep(file)))
            failAt(manifest.file, 0,
                   "has two files of buffer " + buffer +
                       (event ? " of event " + std::to_string(*event) : ""));
        if (!found || isDeep(*found)) found = &file;
    }
    return found;
}

void readEvents(ReplayInput& input) {
    std::vector<int> events;
    for (const ManifestFile& file : input.manifest.files)
        if (file.event) events.push_back(*file.event);
    std::sort(events.begin(), events.end());
    events.erase(std::unique(events.begin(), events.end()), events.end());
    for (const int event : events) {
        const ManifestFile* rays = find(input.manifest, "rays", event);
        const ManifestFile* hits = find(input.manifest, "hits", event);
        if (!rays)
            failAt(input.manifest.file, 0,
                   "has hits of event " + std::to_string(event) + ", and no rays");
        if (!hits) {
            input.ignored.push_back(rays->file.filename().string() + ": rays without hits");
            continue;
        }
        DumpedHits& dumped = input.events.emplace_back();
        dumped.event = event;
        dumped.rays = readRays(*rays, input, input.ignored);
        readHits(*hits, input, dumped, input.ignored);
    }
}

} // namespace

ReplayInput readReplay(const std::filesystem::path& folder) {
    ReplayInput input;
    input.manifest = readManifest(folder, input.ignored);
    const Manifest& manifest = input.manifest;
    const ManifestFile* triangles = find(manifest, "triangles");
    if (!triangles) failAt(manifest.file, 0, "has no file of buffer triangles");
    input.geometry.frame.mode = manifest.settings.mode;
    input.geometry.triangles = readTriangles(*triangles, manifest, input.ignored);

    const ManifestFile *depth = find(manifest, "depth"), *ids = find(manifest, "ids");
    if ((depth || ids) && manifest.views.empty())
        failAt(manifest.file, 0, "has no view_frames, which depth and ids need");
    if (ids && !depth)
        failAt(manifest.file, 0, "has ids without depth, whose bounds say what a bin is");
    for (const uint32_t id : manifest.atEye.value_or(std::vector<uint32_t>{}))
        if (id >= input.geometry.triangles.size())
            failAt(manifest.file, 0,
                   "at_eye has " + std::to_string(id) + ", where there are " +
                       std::to_string(input.geometry.triangles.size()) + " triangles");
    if (depth) {
        input.grid = readDepth(depth->file, input, input.hasPyramid);
        input.grid->atEye = manifest.atEye ? *manifest.atEye : trianglesAtEye(input.geometry);
        std::sort(input.grid->atEye.begin(), input.grid->atEye.end());
    }
    input.hasLists = ids != nullptr;
    if (ids) input.entries = readEntries(ids->file, input);
    if (depth) fillLists(input.entries, *input.grid);
    readEvents(input);
    return input;
}

} // namespace dirt
