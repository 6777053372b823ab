#include "backend_cpu/light_grid.h"

#include "backend_cpu/light_cone.h"
#include "backend_cpu/light_raster.h"
#include "core/trace/ray.h"

#include <algorithm>
#include <cfloat>
#include <cmath>

#include <glm/geometric.hpp>

namespace dirt {
namespace {

constexpr size_t kTrianglesPerPiece = 2048;

/// Tiles in the light's cone for each triangle of the scene: fewer make lists long, more cost time
/// to fill.
constexpr double kTilesPerTriangle = 0.25;
constexpr int kLeastTiles = 16, kMostTiles = 4096;

/// More triangles than this beside the light, which every ray tests, are no gain.
constexpr size_t kMostClose = 16;

// Which tile a ray is looked up in. u = 2^-24, n tiles along a face, of width 2/n; p = o - L is the
// ray's origin seen from the light, |p| <= P, norms are the largest component's.
//
// The direction d is L - o rounded, so at t the ray is at (1 - t) p + t e from the light, with
// |e_i| <= u |p_i|. Where it is at w >= r there, its slopes differ from those of p by less than
// 2 u P / r (1 + 2^-10), which for r = 40 u n P is 1/40 of a tile. The tile of p is found in float:
// p's components, their quotient, the sum with 1 and the product are off by 4 u n of a tile, 1/1024
// for n <= 4096. rasterFromLight adds 1/64. Together that is less than the guard of 1/16.
// Triangles that come nearer than r to the light are `close`, and tested by all rays.
constexpr double kNearest = 40.0 * 0x1p-24;

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
    const double error = 0x1p-46 * t.length * t.length;
    return std::abs(t.determinant) - error * t.size <= distance * (sum(t.normal) + error);
}

/// The planes of a triangle, scaled so that the edges' largest normal has the norm 1, and that of
/// the triangle too.
///
/// The margin. Of an edge's plane e = b x c, seen from the light, a ray's exact determinant is
/// d . ((b - o) x (c - o)), and with d = -p + f, |f_i| <= u |p_i|, that is -e . p but for
/// f . ((b - p) x (c - b)), less than u |p| (|e|_1 + 2 |p| |c - b|_1). The float evaluation of e .
/// p adds 5 u |e|_1 |p| (e, p, the products and two sums), the cross product in double 2^-48 size^2
/// |p|. Of the own plane, n . p - offset, the sign is that of n . (o - a) exactly. Here it is off
/// by 5 u |p| and 2 u |offset|, and by a = (2^-48 length^2 / |n|_1 + 2^-50) size from double, and
/// |p| is not below `nearest`. An |offset| above 2 |p| leaves more than half of it, beyond doubt.
/// So a lane beyond the margin has the exact sign.
LightRecord makeRecord(const LightTriangle& t, uint32_t id, const LightGrid& grid) {
    LightRecord record{};
    record.id = id;
    record.margin = FLT_MAX; // decides nothing
    const double scale = std::max({sum(t.edges[0]), sum(t.edges[1]), sum(t.edges[2])});
    const double own = sum(t.normal), square = t.size * t.size;
    if (t.edgeOn || !(scale > 0x1p-40 * square)) return record;
    const double length =
        std::max({sum(t.v[1] - t.v[0]), sum(t.v[2] - t.v[1]), sum(t.v[0] - t.v[2])});
    const double rounding =
        0x1p-46 * square / scale +
        (0x1p-47 * t.length * t.length / own + 0x1p-50) * (1.0 + t.size / grid.nearest);
    const double margin = 0x1p-24 * (16.0 + 2.5 * grid.reach * length / scale) + rounding;
    if (!(margin < 0.5)) return record;
    const double sign = t.determinant < 0.0 ? -1.0 : 1.0;
    for (int i = 0; i < 4; ++i) {
        const glm::dvec3 n = i < 3 ? t.edges[i] * (sign / scale) : t.normal * (sign / own);
        record.x[i] = (float) n.x, record.y[i] = (float) n.y, record.z[i] = (float) n.z;
    }
    record.offset = (float) (sign * t.determinant / own);
    record.margin = (float) margin;
    return record;
}

/// Which of the faces a triangle may touch. Most lie in one, well inside.
template <class Visit>
void forEachFace(const LightTriangle& t, const LightGrid& grid, Visit&& visit) {
    int common = -1;
    for (int i = 0; i < 3; ++i) {
        const glm::dvec3 m = glm::abs(t.v[i]);
        const int axis = m.x > m.y ? (m.x > m.z ? 0 : 2) : (m.y > m.z ? 1 : 2);
        const int face = 2 * axis + (t.v[i][axis] < 0.0);
        const double inner = m[axis] * (1.0 - 4.0 * kLightGuard / grid.tiles);
        const bool inside = m[(axis + 1) % 3] < inner && m[(axis + 2) % 3] < inner;
        if (!inside || (i > 0 && face != common)) {
            for (const LightFace& each : grid.faces)
                if (each.columns > 0) visit(each);
            return;
        }
        common = face;
    }
    if (grid.faces[common].columns > 0) visit(grid.faces[common]);
}

void scan(const FrameGeometry& geometry, const LightGrid& grid, size_t begin, size_t end,
          LightPiece& piece) {
    piece.records.clear();
    piece.fragments.clear();
    piece.close.clear();
    for (size_t id = begin; id < end; ++id) {
        const LightTriangle triangle(geometry.triangles[id], grid.position);
        if (mayBeWithin(triangle, grid.nearest)) {
            piece.close.push_back((uint32_t) id);
            continue;
        }
        const uint32_t record = (uint32_t) piece.records.size();
        const size_t before = piece.fragments.size();
        forEachFace(triangle, grid, [&](const LightFace& face) {
            rasterFromLight(triangle, face, grid.tiles, 0.5 * grid.nearest,
                            [&](uint32_t tile, float near) {
                                piece.fragments.push_back({tile, record, near});
                            });
        });
        if (piece.fragments.size() > before)
            piece.records.push_back(makeRecord(triangle, (uint32_t) id, grid));
    }
}

void join(uint32_t tiles, Executor& executor, LightGrid& grid) {
    const std::vector<LightPiece>& pieces = grid.pieces;
    std::vector<FragmentPiece> fragments;
    uint32_t records = 0;
    for (const LightPiece& piece : pieces) {
        fragments.push_back({piece.fragments, records});
        records += (uint32_t) piece.records.size();
    }
    sortIntoTiles(fragments, tiles, executor, grid.lists);
    grid.records.resize(records);
    executor.forRange(pieces.size(), 1, [&](size_t i, size_t) {
        std::copy(pieces[i].records.begin(), pieces[i].records.end(),
                  grid.records.begin() + fragments[i].firstItem);
    });
}

} // namespace

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
    edgeOn = !(std::abs(determinant) > (0x1p-46 * length * length + 0x1p-49 * sum(normal)) * size);
}

uint64_t LightGrid::bytes() const {
    return lists.bytes() + records.size() * sizeof(LightRecord);
}

uint64_t LightGrid::pieceBytes() const {
    uint64_t bytes = 0;
    for (const LightPiece& piece : pieces)
        bytes += piece.records.capacity() * sizeof(LightRecord) +
                 piece.fragments.capacity() * sizeof(DepthFragment);
    return bytes;
}

void fillLightGrid(const FrameGeometry& geometry, const Spotlight& light, Executor& executor,
                   LightGrid& grid) {
    grid.tiles = 0;
    const size_t count = geometry.triangles.size();
    grid.position = geometry.frame.toGrid(light.position);
    // Origins lie within the scene, whose coordinates are below 2, or a rounding beside it.
    grid.reach = 2.5f + std::max({std::abs(grid.position.x), std::abs(grid.position.y),
                                  std::abs(grid.position.z)});
    if (!(grid.reach < 0x1p20f)) return;
    const LightCone cone(light, geometry.frame);
    const double wanted = std::sqrt(kTilesPerTriangle * (double) count / (6.0 * cone.part()));
    grid.tiles = (int) std::clamp(wanted, (double) kLeastTiles, (double) kMostTiles);
    grid.nearest = (float) (kNearest * grid.tiles * grid.reach);
    const uint32_t tiles = setFaces(cone, grid.tiles, grid.faces);

    grid.pieces.resize((count + kTrianglesPerPiece - 1) / kTrianglesPerPiece);
    executor.forRange(count, kTrianglesPerPiece, [&](size_t begin, size_t end) {
        scan(geometry, grid, begin, end, grid.pieces[begin / kTrianglesPerPiece]);
    });
    grid.close.clear();
    for (const LightPiece& piece : grid.pieces)
        grid.close.insert(grid.close.end(), piece.close.begin(), piece.close.end());
    if (grid.close.size() > kMostClose)
        grid.tiles = 0;
    else
        join(tiles, executor, grid);
}

} // namespace dirt
