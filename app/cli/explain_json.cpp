#include "app/cli/explain_json.h"

namespace dirt {

namespace {

Json idJson(uint32_t primitive) {
    return primitive == kNoPrimitive ? Json() : Json(primitive);
}

Json boundsJson(const DepthBounds& bounds) {
    return bounds.empty() ? Json() : Json({bounds.near, bounds.far});
}

Json triangleJson(const TriangleTrail& tested) {
    Json json = {{"id", tested.id}, {"result", word(tested.result)}};
    if (tested.result == Tested::missed) {
        json["refused"] = word(tested.refusal.reason);
        json["edge_signs"] = {tested.refusal.a, tested.refusal.b, tested.refusal.c};
    } else {
        json["t"] = tested.hit.t;
        json["u"] = tested.hit.u;
        json["v"] = tested.hit.v;
    }
    return json;
}

Json trianglesJson(const std::vector<TriangleTrail>& triangles) {
    Json list = Json::array();
    for (const TriangleTrail& tested : triangles) list.push_back(triangleJson(tested));
    return list;
}

Json tileJson(const TileTrail& tile) {
    Json bins = Json::array();
    for (const BinTrail& bin : tile.bins)
        bins.push_back({{"bin", bin.bin},
                        {"listed", bin.listed},
                        {"triangles", trianglesJson(bin.triangles)}});
    return {{"tile", {tile.column, tile.row}},
            {"t", {tile.visit.begin, tile.visit.end}},
            {"depths", {tile.visit.near, tile.visit.far}},
            {"bounds", boundsJson(tile.bounds)},
            {"bin_range", {tile.firstBin, tile.lastBin}},
            {"bins", bins}};
}

Json viewJson(const ViewTrail& view) {
    Json cells = Json::array(), tiles = Json::array();
    for (const CellLook& cell : view.cells)
        cells.push_back({{"level", cell.level},
                         {"cell", {cell.column, cell.row}},
                         {"depths", {cell.near, cell.far}},
                         {"bounds", boundsJson(cell.bounds)},
                         {"passed_over", cell.passedOver}});
    for (const TileTrail& tile : view.tiles) tiles.push_back(tileJson(tile));
    return {{"view", view.span.view},
            {"t", {view.span.begin, view.span.end}},
            {"cells", cells},
            {"tiles", tiles}};
}

} // namespace

Json hitJson(const Hit& hit) {
    if (!hit.found()) return {};
    return {{"primitive", hit.primitive}, {"t", hit.t},      {"u", hit.u}, {"v", hit.v},
            {"view", hit.view},           {"tile", hit.tile}};
}

Json rayJson(const ExplainedRay& explained) {
    const Ray& ray = explained.ray;
    Json json = {{"kind", explained.kind},
                 {"origin", vectorJson(ray.origin)},
                 {"direction", vectorJson(ray.direction)},
                 {"skip", idJson(ray.skip)}};
    if (explained.maxT) json["max_t"] = *explained.maxT;
    if (!explained.trail) return json;
    const RayTrail& trail = *explained.trail;
    json["cells"] = trail.counts.steps;
    json["tiles"] = trail.counts.tiles;
    json["bins"] = trail.counts.bins;
    json["tests"] = trail.counts.tests;
    if (trail.maxT)
        json["blocked"] = trail.blocked;
    else
        json["hit"] = hitJson(trail.hit);
    json["at_eye"] = trianglesJson(trail.atEye);
    json["views"] = Json::array();
    for (const ViewTrail& view : trail.views) json["views"].push_back(viewJson(view));
    return json;
}

Json eventJson(const EventAccount& event, const std::vector<ExplainedRay>& rays) {
    const SurfacePoint& point = event.point;
    Json json = {{"event", event.event}, {"rasterized", event.rasterized}};
    json["point"] = Json();
    if (point.found())
        json["point"] = {{"primitive", point.primitive},
                         {"u", point.u},
                         {"v", point.v},
                         {"position", vectorJson(point.position)},
                         {"geometric_normal", vectorJson(point.geometricNormal)},
                         {"shading_normal", vectorJson(point.shadingNormal)},
                         {"diffuse", vectorJson(point.diffuse)}};
    json["traced_hit"] = hitJson(event.hit);
    json["lit"] = event.shadowRay ? Json(event.lit) : Json();
    json["emitted"] = vectorJson(event.emitted);
    json["reflected"] = vectorJson(event.reflected);
    json["added"] = vectorJson(event.added);
    json["rays"] = Json::array();
    json["disagreements"] = Json::array();
    for (const ExplainedRay& ray : rays) {
        json["rays"].push_back(rayJson(ray));
        const std::string text = disagreement(event, ray);
        if (!text.empty()) json["disagreements"].push_back(text);
    }
    return json;
}

Json entriesJson(const std::vector<TileEntry>& entries) {
    Json list = Json::array();
    for (const TileEntry& entry : entries) {
        list.push_back({{"primitive", entry.id},
                        {"view", entry.view},
                        {"tile", {entry.column, entry.row}},
                        {"due", entry.isDue},
                        {"bins", entry.bins},
                        {"right", entry.isRight()}});
        if (!entry.isDue) continue;
        list.back()["depths"] = {entry.depths.near, entry.depths.far};
        list.back()["due_bins"] = {entry.firstBin, entry.lastBin};
        list.back()["polygon"] = Json::array();
        for (const glm::dvec3& corner : entry.polygon)
            list.back()["polygon"].push_back({corner.x, corner.y, corner.z});
    }
    return list;
}

} // namespace dirt
