#include "backend_cpu/light/light_raster.h"

#include "core/grid/repeated.h"

#include <cfloat>

#include <glm/geometric.hpp>

// Compiles what follows once for each instruction set that Highway knows on this architecture.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "backend_cpu/light/light_raster.cpp"
#include <hwy/foreach_target.h>

#include "backend_cpu/light/light_setup-inl.h"

#ifndef DIRT_LIGHT_RASTER_SCALAR
#define DIRT_LIGHT_RASTER_SCALAR
namespace dirt {
namespace {

double largest(const glm::dvec3& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}
double sum(const glm::dvec3& v) {
    return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
}

/// Whether the triangle may have a point with all |coordinates| below \p distance.
bool mayBeWithin(const LightTriangle& t, double distance) {
    for (int i = 0; i < 3; ++i) {
        if (t.v[0][i] > distance && t.v[1][i] > distance && t.v[2][i] > distance) return false;
        if (-t.v[0][i] > distance && -t.v[1][i] > distance && -t.v[2][i] > distance) return false;
    }
    // The plane's distance; what is added covers the errors stated with LightTriangle.
    const double error = kLightError * t.length * t.length;
    return std::abs(t.determinant) - error * t.size <= distance * (sum(t.normal) + error);
}

} // namespace
} // namespace dirt
#endif

HWY_BEFORE_NAMESPACE();
namespace dirt::HWY_NAMESPACE {

void ScanFromLight(const FrameGeometry& geometry, LightGrid& grid, size_t begin, size_t end,
                   LightPiece& piece) {
    const LightFaces faces(grid.tree);
    const uint32_t lanes = (uint32_t) hn::Lanes(LightTag());
    for (size_t first = begin; first < end; first += lanes) {
        const uint32_t count = (uint32_t) std::min<size_t>(lanes, end - first);
        const LightLanes triangles(geometry.triangles.data(), first, count, grid.position);
        LightRanges ranges;
        triangles.findRanges(faces, grid, ranges);
        uint32_t listed = 0;
        for (uint32_t rest = (ranges.simple | ranges.other) & ((1u << count) - 1); rest != 0;
             rest &= rest - 1) {
            const uint32_t lane = (uint32_t) hwy::Num0BitsBelowLS1Bit_Nonzero32(rest);
            const uint32_t id = (uint32_t) first + lane;
            const Triangle& triangle = geometry.triangles[id];
            if (isRepeated(geometry, id)) continue;
            const size_t before = piece.fragments.size();
            auto emit = [&](uint32_t tile, float near, uint32_t box) {
                piece.fragments.push_back({tile, id, near, box});
            };
            if ((ranges.simple >> lane & 1) != 0) {
                LightLister lister(grid, grid.tree.faces[(size_t) ranges.face[lane]], triangle,
                                   ranges.guard[lane], ranges.least[lane], emit);
                lister.list({ranges.x0[lane], ranges.x1[lane], ranges.y0[lane], ranges.y1[lane]});
            } else {
                if (mayBeWithin(LightTriangle(triangle, grid.position), grid.nearest)) {
                    piece.close.push_back(id);
                    continue;
                }
                for (const LightFace& face : grid.tree.faces)
                    if (face.columns > 0)
                        rasterFromLight(grid, triangle, face, 0.5 * grid.nearest, emit);
            }
            if (piece.fragments.size() > before) listed |= 1u << lane;
        }
        if (listed != 0) triangles.writeRecords(grid, listed, grid.records.data() + first);
    }
}

} // namespace dirt::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dirt {

HWY_EXPORT(ScanFromLight);

LightTriangle::LightTriangle(const Triangle& t, const glm::vec3& light) {
    const glm::dvec3 origin(light);
    v[0] = glm::dvec3(t.a) - origin, v[1] = glm::dvec3(t.b) - origin;
    v[2] = glm::dvec3(t.c) - origin;
    edges[0] = glm::cross(v[1], v[2]);
    edges[1] = glm::cross(v[2], v[0]);
    edges[2] = glm::cross(v[0], v[1]);
    const glm::dvec3 ab = glm::dvec3(t.b) - glm::dvec3(t.a);
    const glm::dvec3 ac = glm::dvec3(t.c) - glm::dvec3(t.a);
    normal = glm::cross(ab, ac);
    determinant = glm::dot(v[0], normal);
    length = std::max(largest(ab), largest(ac));
    size = std::max({largest(v[0]), largest(v[1]), largest(v[2])});
    const double error = kLightError * length * length + kLightNormalError * sum(normal);
    edgeOn = !(std::abs(determinant) > error * size);
}

LightPlanes::LightPlanes(const LightTriangle& triangle, const LightFace& face, double guard)
    : guard_(guard), guardSlope_(guard / kPlacesPerSlope) {
    // An edge's plane n . (s, t, 1) >= 0, taken at the border of the widened rows where it is
    // largest, leaves a bound of s, off by less than 2^-48 size^2 / |n_x|: edges are heeded where
    // that is less than half a place. Edge-on triangles have no inner side.
    const double orientation = triangle.determinant < 0.0 ? -1.0 : 1.0;
    for (int i = 0; i < 3; ++i) {
        const glm::dvec3 n = orientation * triangle.edges[i];
        const double nx = n[face.axisX];
        const bool clear =
            !triangle.edgeOn && std::abs(nx) > kLightEdgeClear * triangle.size * triangle.size;
        edges_[i] = {n[face.axisY], face.signW * n[face.axisW], clear ? -1.0 / nx : 0.0,
                     clear ? nx > 0.0 ? 1 : -1 : 0};
    }
    // 1/w is affine in the slopes: (normal . (s, t, 1)) / determinant, largest in a square's
    // corner. Both are taken where their errors are below 2^-24 of them.
    const glm::dvec3 n = orientation * triangle.normal;
    inverseDepth_ = {n[face.axisX], n[face.axisY], face.signW * n[face.axisW]};
    depth_ = std::abs(triangle.determinant);
    const double area = kLightDepthClear * triangle.length * triangle.length;
    unclear_ = depth_ > area * triangle.size ? area : HUGE_VAL;
}

void LightPlanes::clip(int y, int size, PlaceBox& box) const {
    const double t0 = y / kPlacesPerSlope - 1.0 - guardSlope_;
    const double t1 = (y + size) / kPlacesPerSlope - 1.0 + guardSlope_;
    double from = -HUGE_VAL, to = HUGE_VAL;
    for (const Edge& edge : edges_) {
        const double bound = (std::max(edge.t * t0, edge.t * t1) + edge.constant) * edge.slope;
        if (edge.side > 0) from = std::max(from, bound);
        if (edge.side < 0) to = std::min(to, bound);
    }
    box.x0 = std::max(box.x0, placeBelow(from, guard_));
    box.x1 = std::min(box.x1, placeAbove(to, guard_));
}

double LightPlanes::near(int x, int y, int size) const {
    const auto largest = [&](double slope, int place) {
        const double low = place / kPlacesPerSlope - 1.0 - guardSlope_;
        const double high = (place + size) / kPlacesPerSlope - 1.0 + guardSlope_;
        return std::max(slope * low, slope * high);
    };
    const double inverse =
        largest(inverseDepth_.x, x) + largest(inverseDepth_.y, y) + inverseDepth_.z;
    return inverse > unclear_ ? depth_ / inverse : 0.0;
}

void scanFromLight(const FrameGeometry& geometry, LightGrid& grid, size_t begin, size_t end,
                   LightPiece& piece) {
    piece.fragments.clear();
    piece.close.clear();
    HWY_DYNAMIC_DISPATCH(ScanFromLight)(geometry, grid, begin, end, piece);
}

} // namespace dirt
#endif // HWY_ONCE
