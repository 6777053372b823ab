#include "scenes/generate/floor.h"

#include <cmath>
#include <vector>

#include <glm/geometric.hpp>

#include "scenes/generate/atrium_materials.h"
#include "scenes/generate/noise.h"

namespace dirt::generate {
namespace {

constexpr double joint = 0.003; // half the width of a joint
constexpr double depth = 0.006; // of a joint
constexpr double grout = -depth;

/// Lays one convex stone, its corners given counter-clockwise from above, as (x, z). Every stone
/// sits a hair higher or lower than its neighbours and shows another part of the quarry.
void layStone(Mesh& mesh, int material, const std::vector<Vec2>& corners, double y,
              std::uint32_t seed) {
    Vec2 centre(0);
    for (const Vec2 corner : corners) {
        centre += corner / static_cast<double>(corners.size());
    }
    const Vec2 shift(hashUnit(seed, 1) * 7, hashUnit(seed, 2) * 7);
    const double top = y + hashRange(-0.0012, 0.0012, seed, 3);
    const bool bevelled = mesh.detail().shows(0.31);
    const auto ring = [&](double inset, double height, double lean) {
        std::vector<std::uint32_t> indices;
        for (const Vec2 corner : corners) {
            const Vec2 toCentre = centre - corner;
            const double length = glm::length(toCentre);
            const Vec2 p = corner + toCentre * std::min(0.4, 1.4 * inset / length);
            const Vec3 normal =
                glm::normalize(Vec3(-toCentre.x * lean, length, -toCentre.y * lean));
            indices.push_back(mesh.addVertex({p.x, height, p.y}, normal, p + shift));
        }
        return indices;
    };
    const auto inner = bevelled ? ring(joint + 0.006, top, 0) : ring(0, y, 0);
    const std::size_t count = corners.size();
    for (std::size_t k = 2; k < count; ++k) {
        mesh.addTriangle(material, inner[0], inner[k - 1], inner[k]);
    }
    if (bevelled) {
        const auto outer = ring(joint, y - depth, 1.2);
        for (std::size_t k = 0; k < count; ++k) {
            const std::size_t next = (k + 1) % count;
            mesh.addTriangle(material, outer[k], outer[next], inner[next]);
            mesh.addTriangle(material, outer[k], inner[next], inner[k]);
        }
    }
}

void layRectangle(Mesh& mesh, int material, Vec2 low, Vec2 high, double y, std::uint32_t seed) {
    layStone(mesh, material, {{low.x, low.y}, {low.x, high.y}, {high.x, high.y}, {high.x, low.y}},
             y, seed);
}

/// A square of lozenges: pale diamonds on the tiles' middles, coloured ones on their corners.
void layLozenges(Mesh& mesh, Vec2 low, double size, int tiles, int colour, int otherColour,
                 std::uint32_t seed) {
    const double tile = size / tiles;
    for (int j = 0; j < tiles; ++j) {
        for (int i = 0; i < tiles; ++i) {
            const Vec2 p = low + Vec2(i, j) * tile;
            const Vec2 mid[4] = {p + Vec2(0, tile / 2), p + Vec2(tile / 2, tile),
                                 p + Vec2(tile, tile / 2), p + Vec2(tile / 2, 0)};
            const Vec2 corner[4] = {p + Vec2(0, tile), p + Vec2(tile, tile), p + Vec2(tile, 0), p};
            const auto stone =
                hashBits(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j), seed);
            layStone(mesh, WhiteMarble, {mid[0], mid[1], mid[2], mid[3]}, 0, stone);
            const int cornerI[4] = {i, i + 1, i + 1, i};
            const int cornerJ[4] = {j + 1, j + 1, j, j};
            for (std::uint32_t k = 0; k < 4; ++k) {
                const int material = (cornerI[k] + cornerJ[k]) % 2 == 0 ? colour : otherColour;
                layStone(mesh, material, {mid[k], corner[k], mid[(k + 1) % 4]}, 0, stone + k + 1);
            }
        }
    }
}

/// A triangle of stone; no quarry yields it in one piece, so it is halved along the line from its
/// middle corner `levels` times.
void layTriangle(Mesh& mesh, int material, Vec2 a, Vec2 b, Vec2 c, int levels, std::uint32_t seed) {
    if (levels == 0 || !mesh.detail().shows(0.22)) {
        layStone(mesh, material, {a, b, c}, 0, seed);
        return;
    }
    const Vec2 middle = (a + c) * 0.5;
    layTriangle(mesh, material, b, middle, a, levels - 1, hashBits(seed, 1));
    layTriangle(mesh, material, c, middle, b, levels - 1, hashBits(seed, 2));
}

/// Nested squares, each turned by an eighth against the one around it.
void layNestedSquares(Mesh& mesh, Vec2 low, double size, std::uint32_t seed) {
    const Vec2 centre = low + Vec2(size / 2);
    const int materials[6] = {Limestone, RedMarble, WhiteMarble, GreenMarble, Limestone, RedMarble};
    double half = size / 2;
    Vec2 outer[4] = {{-half, -half}, {-half, half}, {half, half}, {half, -half}};
    for (std::uint32_t ring = 0; ring < 5; ++ring) {
        Vec2 inner[4];
        for (int k = 0; k < 4; ++k) {
            inner[k] = (outer[k] + outer[(k + 1) % 4]) * 0.5;
        }
        for (std::uint32_t k = 0; k < 4; ++k) {
            layTriangle(mesh, materials[ring], centre + inner[(k + 3) % 4], centre + outer[k],
                        centre + inner[k], ring < 2 ? 2 - static_cast<int>(ring) : 0,
                        seed + ring * 64 + k);
        }
        std::copy(inner, inner + 4, outer);
    }
    layStone(mesh, materials[5],
             {centre + outer[0], centre + outer[1], centre + outer[2], centre + outer[3]}, 0,
             seed + 99);
}

} // namespace

Mesh makeCourtFloor(const Detail& detail, Vec2 halfExtent) {
    Mesh mesh(detail);
    mesh.addQuad(Grout, {-halfExtent.x, grout, halfExtent.y}, {halfExtent.x, grout, halfExtent.y},
                 {halfExtent.x, grout, -halfExtent.y}, {-halfExtent.x, grout, -halfExtent.y});
    // Two by four square fields between bands; what is left over becomes the border.
    constexpr int across = 2;
    constexpr int along = 4;
    constexpr double band = 0.5;
    const double field = std::min((2 * halfExtent.x - (across + 1) * band) / across,
                                  (2 * halfExtent.y - (along + 1) * band) / along);
    const Vec2 half(across * field / 2 + (across + 1) * band / 2,
                    along * field / 2 + (along + 1) * band / 2);
    const int tiles = detail.shows(0.285) ? 7 : detail.shows(0.18) ? 5 : 3;
    const Vec2 start = -half;
    const auto seed = [](int i, int j) {
        return hashBits(77, static_cast<std::uint32_t>(i + 64), static_cast<std::uint32_t>(j + 64));
    };
    for (int j = 0; j <= along; ++j) {
        for (int i = 0; i <= across; ++i) {
            const Vec2 p = start + Vec2(i, j) * (field + band);
            layRectangle(mesh, RedMarble, p, p + Vec2(band), 0, seed(i, j));
            // Bands are laid in slabs.
            const int slabs = detail.shows(0.25) ? 5 : 1;
            for (int k = 0; k < slabs; ++k) {
                const double a = field * k / slabs;
                const double b = field * (k + 1) / slabs;
                if (i < across) {
                    layRectangle(mesh, Limestone, p + Vec2(band + a, 0), p + Vec2(band + b, band),
                                 0, seed(i * 8 + k, j + 100));
                }
                if (j < along) {
                    layRectangle(mesh, Limestone, p + Vec2(0, band + a), p + Vec2(band, band + b),
                                 0, seed(i * 8 + k, j + 200));
                }
            }
            if (i == across || j == along) {
                continue;
            }
            const Vec2 low = p + Vec2(band);
            if ((i + j) % 2 == 0) {
                layLozenges(mesh, low, field, tiles, GreenMarble, RedMarble, seed(i, j + 300));
            } else {
                layNestedSquares(mesh, low, field, seed(i, j + 400));
            }
        }
    }
    const int stones = detail.shows(0.25) ? 24 : 4;
    for (int k = 0; k < stones; ++k) {
        const double a = 2.0 * k / stones - 1;
        const double b = 2.0 * (k + 1) / stones - 1;
        const int material = GreenMarble;
        const Vec2 e = halfExtent;
        layRectangle(mesh, material, {a * half.x, half.y}, {b * half.x, e.y}, 0, seed(k, 500));
        layRectangle(mesh, material, {a * half.x, -e.y}, {b * half.x, -half.y}, 0, seed(k, 501));
        layRectangle(mesh, material, {half.x, a * e.y}, {e.x, b * e.y}, 0, seed(k, 502));
        layRectangle(mesh, material, {-e.x, a * e.y}, {-half.x, b * e.y}, 0, seed(k, 503));
    }
    return mesh;
}

void addPaving(Mesh& mesh, Vec2 low, Vec2 high, double y, double tile) {
    const double size = mesh.detail().shows(0.32)   ? tile
                        : mesh.detail().shows(0.21) ? 2 * tile
                                                    : 4 * tile;
    const int across = std::max(1, static_cast<int>(std::lround((high.x - low.x) / size)));
    const int along = std::max(1, static_cast<int>(std::lround((high.y - low.y) / size)));
    const Vec2 step = (high - low) / Vec2(across, along);
    mesh.addQuad(Grout, {low.x, y + grout, high.y}, {high.x, y + grout, high.y},
                 {high.x, y + grout, low.y}, {low.x, y + grout, low.y});
    for (int j = 0; j < along; ++j) {
        for (int i = 0; i < across; ++i) {
            const auto seed =
                hashBits(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j), 91);
            const Vec2 p = low + Vec2(i, j) * step;
            layRectangle(mesh, (i + j) % 2 == 0 ? Limestone : RedMarble, p, p + step, y, seed);
        }
    }
}

} // namespace dirt::generate
