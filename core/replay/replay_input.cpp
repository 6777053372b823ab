#include "core/replay/replay_input.h"

#include "core/io/load_report.h"
#include "core/replay/structure_tables.h"
#include "core/replay/table.h"
#include "core/trace/intersect.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

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

/// The columns of a ray; whoever reads more appends them.
std::vector<Column> rayColumns() {
    return {{"origin.X", Kind::number},    {"origin.Y", Kind::number},
            {"origin.Z", Kind::number},    {"direction.X", Kind::number},
            {"direction.Y", Kind::number}, {"direction.Z", Kind::number},
            {"skip", Kind::optionalWord}};
}

uint32_t idAt(const Table& table, size_t row, size_t column, const char* name,
              const ReplayInput& input) {
    const uint32_t id = table.word(row, column);
    if (id != kNoPrimitive && id >= input.geometry.triangles.size())
        table.fail(row, std::string(name) + " is " + std::to_string(id) + ", where there are " +
                            std::to_string(input.geometry.triangles.size()) + " triangles");
    return id;
}

/// The ray of a row whose first columns are rayColumns.
Ray rayAt(const Table& table, size_t row, const ReplayInput& input) {
    Ray ray;
    for (size_t i = 0; i < 3; ++i) {
        ray.origin[(int) i] = table.number(row, i);
        ray.direction[(int) i] = table.number(row, 3 + i);
    }
    if (table.has[6]) ray.skip = idAt(table, row, 6, "skip", input);
    return ray;
}

std::vector<Ray> readRays(const ManifestFile& file, const ReplayInput& input,
                          std::vector<std::string>& ignored) {
    const Table table = readOne(file, rayColumns(),
                                {"pdf", "throughput.R", "throughput.G", "throughput.B"}, ignored);
    checkPixels(table, input.manifest.settings);
    std::vector<Ray> rays(table.rows);
    for (size_t row = 0; row < table.rows; ++row) rays[row] = rayAt(table, row, input);
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
        hit.primitive = idAt(table, row, 0, "primitive", input);
        hit.t = table.number(row, 1);
        hit.u = table.number(row, 2);
        hit.v = table.number(row, 3);
        hit.view = table.word(row, 4);
        hit.tile = table.word(row, 5);
        if (hit.found() && event.filed) checkTile(table, row, hit, input.manifest.views);
    }
}

/// A tile's column or row, which has to be below \p count.
uint32_t placeAt(const Table& table, size_t row, size_t column, const char* name, int count) {
    const uint32_t place = table.word(row, column);
    if (place >= (uint32_t) count)
        table.fail(row, std::string(name) + " is " + std::to_string(place) + ", where there are " +
                            std::to_string(count));
    return place;
}

/// The view and tile of a blocker from three columns, of which \p first is the view's.
void readPlace(const Table& table, size_t row, size_t first, const std::vector<View>& views,
               Hit& blocker) {
    blocker.view = table.word(row, first);
    checkTile(table, row, blocker, views);
    if (blocker.view == views.size()) return; // at the eye
    const View& view = views[blocker.view];
    const uint32_t column = placeAt(table, row, first + 1, "column", view.columns);
    blocker.tile =
        placeAt(table, row, first + 2, "row", view.rows) * (uint32_t) view.columns + column;
}

DumpedShadows readShadows(const ManifestFile& file, const ReplayInput& input,
                          std::vector<std::string>& ignored) {
    std::vector<Column> columns = rayColumns();
    const size_t tMax = columns.size(), occluded = tMax + 1, blocker = tMax + 2, view = tMax + 3;
    columns.push_back({"tMax", Kind::number});
    columns.push_back({"occluded", Kind::word});
    for (const char* name : {"blocker", "view", "column", "row"})
        columns.push_back({name, Kind::optionalWord});
    const Table table = readOne(file, columns, {"t"}, ignored);
    checkPixels(table, input.manifest.settings);
    if (table.has[view] != table.has[view + 1] || table.has[view] != table.has[view + 2])
        table.fail("has some of the columns view, column and row");
    DumpedShadows shadows;
    shadows.event = *file.event;
    shadows.named = table.has[blocker];
    shadows.filed = shadows.named && table.has[view] && !input.manifest.views.empty();
    shadows.blockers.resize(table.rows);
    for (size_t row = 0; row < table.rows; ++row) {
        shadows.rays.push_back(rayAt(table, row, input));
        shadows.tMax.push_back(table.number(row, tMax));
        const uint32_t answer = table.word(row, occluded);
        if (answer > 1) table.fail(row, "occluded is " + std::to_string(answer) + ", not 0 or 1");
        shadows.occluded.push_back((uint8_t) answer);
        if (!shadows.named) continue;
        Hit& found = shadows.blockers[row];
        found.primitive = idAt(table, row, blocker, "blocker", input);
        if (found.found() && shadows.filed)
            readPlace(table, row, view, input.manifest.views, found);
    }
    return shadows;
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

/// Rays and hits of an event, which may have neither.
void readHitsOf(int event, ReplayInput& input) {
    const ManifestFile* rays = find(input.manifest, "rays", event);
    const ManifestFile* hits = find(input.manifest, "hits", event);
    if (hits && !rays)
        failAt(input.manifest.file, 0,
               "has hits of event " + std::to_string(event) + ", and no rays");
    if (rays && !hits)
        input.ignored.push_back(rays->file.filename().string() + ": rays without hits");
    if (!rays || !hits) return;
    DumpedHits& dumped = input.events.emplace_back();
    dumped.event = event;
    dumped.rays = readRays(*rays, input, input.ignored);
    readHits(*hits, input, dumped, input.ignored);
}

void readEvents(ReplayInput& input) {
    std::set<int> events;
    for (const ManifestFile& file : input.manifest.files)
        if (file.event) events.insert(*file.event);
    for (const int event : events) {
        readHitsOf(event, input);
        if (const ManifestFile* shadows = find(input.manifest, "shadowrays", event))
            input.shadows.push_back(readShadows(*shadows, input, input.ignored));
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
