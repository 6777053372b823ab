#include "app/cli/explain_text.h"

#include "core/dump/dump.h"
#include "core/path/world_position.h"

#include <cstdarg>
#include <cstdio>

namespace dirt {

namespace {

[[gnu::format(printf, 1, 2)]] std::string format(const char* pattern, ...) {
    char text[512];
    va_list arguments;
    va_start(arguments, pattern);
    std::vsnprintf(text, sizeof text, pattern, arguments);
    va_end(arguments);
    return text;
}

std::string vectorText(glm::dvec3 v) {
    return format("(%.9g, %.9g, %.9g)", v.x, v.y, v.z);
}

std::string materialOf(const Scene& scene, uint32_t primitive) {
    if (primitive >= scene.mesh.materials.size()) return "";
    return " of '" + scene.materials[scene.mesh.materials[primitive]].name + "'";
}

std::string signText(const Refusal& refusal) {
    const auto sign = [](int s) { return s < 0 ? '-' : s > 0 ? '+' : '0'; };
    return format("edges %c%c%c", sign(refusal.a), sign(refusal.b), sign(refusal.c));
}

std::string triangleText(const TriangleTrail& tested) {
    const std::string id = format("          %u  ", tested.id);
    if (tested.result == Tested::missed)
        return id + format("missed: %s, %s\n", word(tested.refusal.reason),
                           signText(tested.refusal).c_str());
    return id + format("t %.9g, u %.6g, v %.6g: %s\n", (double) tested.hit.t, (double) tested.hit.u,
                       (double) tested.hit.v, word(tested.result));
}

std::string tileText(const TileTrail& tile) {
    std::string text = format(
        "      tile (%d, %d)  t %.9g .. %.9g, depths %.9g .. %.9g of %.9g .. %.9g, bins %d .. %d\n",
        tile.column, tile.row, tile.visit.begin, tile.visit.end, (double) tile.visit.near,
        (double) tile.visit.far, (double) tile.bounds.near, (double) tile.bounds.far, tile.firstBin,
        tile.lastBin);
    for (const BinTrail& bin : tile.bins) {
        if (bin.listed == 0) continue;
        text += format("        bin %d lists %zu\n", bin.bin, bin.listed);
        for (const TriangleTrail& tested : bin.triangles) text += triangleText(tested);
    }
    return text;
}

/// Corners in the view's frame, four a line.
std::string polygonText(const TileEntry& entry) {
    std::string text;
    for (size_t i = 0; i < entry.polygon.size(); ++i)
        text += (i % 4 > 0 ? " "
                 : i > 0   ? "\n      "
                           : "    corners (x, y, w) ") +
                vectorText(entry.polygon[i]);
    return text.empty() ? text : text + "\n";
}

std::string cellText(const CellLook& cell) {
    return format("      cell (%d, %d) of level %d: depths %.9g .. %.9g, %s\n", cell.column,
                  cell.row, cell.level, cell.near, cell.far,
                  cell.bounds.empty() ? "empty: passed over"
                  : cell.passedOver   ? format("holds %.9g .. %.9g: passed over",
                                               (double) cell.bounds.near, (double) cell.bounds.far)
                                          .c_str()
                  : cell.level > 0 ? "looked into"
                                   : "visited");
}

/// Cells and tiles as they came: a tile follows the cell of level 0 that is it.
std::string viewText(const Grid& grid, const ViewTrail& view) {
    std::string text =
        format("    view %d (%s)  t %.9g .. %.9g\n", view.span.view,
               viewName(grid, (size_t) view.span.view).c_str(), view.span.begin, view.span.end);
    size_t tile = 0;
    for (const CellLook& cell : view.cells) {
        const bool isTile = cell.level == 0 && !cell.passedOver;
        if (!isTile) text += cellText(cell);
        if (isTile && tile < view.tiles.size() && view.tiles[tile].column == cell.column &&
            view.tiles[tile].row == cell.row)
            text += tileText(view.tiles[tile++]);
    }
    return text;
}

/// How much work a ray's way was, and what it found.
std::string trailText(const RayTrail& trail) {
    std::string text =
        format("%llu cells, %llu tiles, %llu bins, %llu tests; ",
               (unsigned long long) trail.counts.steps, (unsigned long long) trail.counts.tiles,
               (unsigned long long) trail.counts.bins, (unsigned long long) trail.counts.tests);
    if (trail.maxT) return text + (trail.blocked ? "blocked\n" : "open\n");
    if (!trail.hit.found()) return text + "hits nothing\n";
    return text + format("hits %u at t %.9g, filed under view %u, tile %u\n", trail.hit.primitive,
                         (double) trail.hit.t, trail.hit.view, trail.hit.tile);
}

} // namespace

const char* word(Tested result) {
    switch (result) {
    case Tested::missed:
        return "missed";
    case Tested::known:
        return "the best hit already";
    case Tested::farther:
        return "too far";
    case Tested::outside:
        return "outside the view";
    case Tested::skipped:
        return "skipped, the ray starts there";
    case Tested::hole:
        return "a hole";
    case Tested::nearest:
        return "hit";
    }
    return "";
}

const char* word(Refusal::Reason reason) {
    switch (reason) {
    case Refusal::Reason::none:
        return "by nothing";
    case Refusal::Reason::filter:
        return "by the float filter";
    case Refusal::Reason::beside:
        return "beside it";
    case Refusal::Reason::inPlane:
        return "in its plane";
    case Refusal::Reason::behind:
        return "behind the origin";
    case Refusal::Reason::floatTest:
        return "by the float test";
    }
    return "";
}

std::string eventText(const Scene& scene, const PathAccount& account, const EventAccount& event) {
    std::string text =
        format("event %d%s\n", event.event, event.rasterized ? ", found by rasterization" : "");
    const SurfacePoint& point = event.point;
    if (point.found()) {
        text +=
            format("  point    primitive %u%s, u %.6g, v %.6g\n", point.primitive,
                   materialOf(scene, point.primitive).c_str(), (double) point.u, (double) point.v);
        text += "  at       " +
                vectorText(worldPosition(scene, account.geometry.frame, point.position)) + "\n";
        text += "  normal   " + vectorText(point.shadingNormal) + ", of the triangle " +
                vectorText(point.geometricNormal) + "\n";
        text += "  diffuse  " + vectorText(point.diffuse) + "\n";
    } else {
        text += event.ray.direction == glm::vec3(0.0f) ? "  point    none: the path has ended\n"
                                                       : "  point    none: nothing is hit\n";
    }
    if (!event.rasterized && event.hit.found())
        text += format("  filed    under view %u, tile %u; fetched %u times\n", event.hit.view,
                       event.hit.tile, event.hit.fetches);
    if (event.event > 0) text += "  weight   " + vectorText(event.ray.throughput) + "\n";
    text += "  light    ";
    text += !event.shadowRay ? "no shadow ray: it would add nothing, or none is traced\n"
            : event.lit      ? "reaches the point\n"
                             : "does not reach the point\n";
    text += "  adds     " + vectorText(event.added) + ": " + vectorText(event.emitted) +
            (point.found() ? " emitted, " : " of the background, ") + vectorText(event.reflected) +
            " of the light\n";
    return text;
}

std::string rayText(const std::optional<Grid>& grid, const ExplainedRay& explained) {
    const Ray& ray = explained.ray;
    std::string text = format("  %s ray, grid frame: from %s along %s", explained.kind.c_str(),
                              vectorText(ray.origin).c_str(), vectorText(ray.direction).c_str());
    if (explained.maxT) text += format(", to t %.9g", (double) *explained.maxT);
    if (ray.skip != kNoPrimitive) text += format(", skips %u", ray.skip);
    text += "\n";
    if (!explained.trail) return text;
    const RayTrail& trail = *explained.trail;
    text += "    " + trailText(trail);
    if (!trail.atEye.empty()) text += "    at the eye\n";
    for (const TriangleTrail& tested : trail.atEye) text += triangleText(tested);
    for (const ViewTrail& view : trail.views) text += viewText(*grid, view);
    return text;
}

std::string rayLine(const ExplainedRay& ray) {
    return ray.kind + " ray: " + (ray.trail ? trailText(*ray.trail) : "no grid\n");
}

std::string tileLine(const Grid& grid, int view, int column, int row) {
    const std::string text = format("tile (%d, %d) of view %d", column, row, view);
    const DepthBounds& bounds = grid.bounds(view, row * grid.views[(size_t) view].columns + column);
    if (bounds.empty()) return text + ", empty";
    return text + format(", depths %.9g .. %.9g, %d bins", (double) bounds.near,
                         (double) bounds.far, grid.settings.bins);
}

std::string entriesText(const Scene& scene, const Grid& grid,
                        const std::vector<TileEntry>& entries) {
    std::string text;
    for (const TileEntry& entry : entries) {
        text += format("  %u%s in view %d (%s), tile (%d, %d): ", entry.id,
                       materialOf(scene, entry.id).c_str(), entry.view,
                       viewName(grid, (size_t) entry.view).c_str(), entry.column, entry.row);
        if (entry.isDue)
            text += format("depths %.9g .. %.9g, bins %d .. %d", (double) entry.depths.near,
                           (double) entry.depths.far, entry.firstBin, entry.lastBin);
        else
            text += "not due";
        if (!entry.isRight()) {
            text += "; LISTED IN";
            if (entry.bins.empty()) text += " NONE";
            for (const int bin : entry.bins) text += format(" %d", bin);
        }
        text += "\n";
        text += polygonText(entry);
    }
    return text;
}

} // namespace dirt
