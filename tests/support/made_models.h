#pragma once

#include "core/scene/scene.h"

#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace dirt::test {

inline void addQuad(Mesh& mesh, glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::vec3 d,
                    uint32_t material = 0) {
    const uint32_t first = (uint32_t) mesh.positions.size();
    mesh.positions.insert(mesh.positions.end(), {a, b, c, d});
    for (const Corners& corners :
         {Corners{first, first + 1, first + 2}, Corners{first, first + 2, first + 3}}) {
        mesh.triangles.push_back(corners);
        mesh.normalIndices.push_back({kNoIndex, kNoIndex, kNoIndex});
        mesh.texcoordIndices.push_back({kNoIndex, kNoIndex, kNoIndex});
        mesh.materials.push_back(material);
    }
}

/// Sides of a box, for those to leave out.
enum BoxSide : unsigned {
    noSide = 0,
    left = 1,
    right = 2,
    bottom = 4,
    top = 8,
    back = 16,
    front = 32
};

/// A box whose faces look outwards, or inwards.
inline void addRoom(Mesh& mesh, glm::vec3 low, glm::vec3 high, bool inwards, unsigned without = 0) {
    for (int axis = 0; axis < 3; ++axis)
        for (int side = 0; side < 2; ++side) {
            if (without & (1u << (2 * axis + side))) continue;
            const int u = (axis + 1) % 3, v = (axis + 2) % 3;
            glm::vec3 corner[4];
            for (int i = 0; i < 4; ++i) {
                corner[i][axis] = side ? high[axis] : low[axis];
                corner[i][u] = i == 1 || i == 2 ? high[u] : low[u];
                corner[i][v] = i >= 2 ? high[v] : low[v];
            }
            if ((side == 1) != inwards)
                addQuad(mesh, corner[0], corner[1], corner[2], corner[3]);
            else
                addQuad(mesh, corner[3], corner[2], corner[1], corner[0]);
        }
}

inline void addBall(Mesh& mesh, glm::vec3 centre, float radius, int rings) {
    const auto at = [=](int i, int j) {
        const double theta = std::numbers::pi * i / rings, phi = std::numbers::pi * j / rings;
        return centre + radius * glm::vec3(std::sin(theta) * std::sin(phi), std::cos(theta),
                                           std::sin(theta) * std::cos(phi));
    };
    for (int i = 0; i < rings; ++i)
        for (int j = 0; j < 2 * rings; ++j)
            addQuad(mesh, at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
}

inline Mesh box(bool inwards) {
    Mesh mesh;
    addRoom(mesh, glm::vec3(-1), glm::vec3(1), inwards);
    return mesh;
}

/// A closed box with a cavity between walls of \p thickness.
inline Mesh hollowBox(float thickness) {
    Mesh mesh = box(false);
    addRoom(mesh, glm::vec3(thickness - 1), glm::vec3(1 - thickness), true);
    return mesh;
}

/// A hall of 20 x 6 x 10 with four pillars.
inline Mesh hall() {
    Mesh mesh;
    addRoom(mesh, {-10, 0, -5}, {10, 6, 5}, true);
    for (float x : {-6.0f, 6.0f})
        for (float z : {-3.0f, 3.0f})
            addRoom(mesh, {x - 0.4f, 0, z - 0.4f}, {x + 0.4f, 6, z + 0.4f}, false);
    return mesh;
}

/// A room of 2 x 2 x 2 with two boxes in it, without one wall.
inline Mesh openRoom(unsigned without) {
    Mesh mesh;
    addRoom(mesh, {-1, 0, -1}, {1, 2, 1}, true, without);
    addRoom(mesh, {-0.6f, 0, -0.6f}, {-0.1f, 1.2f, -0.1f}, false);
    addRoom(mesh, {0.2f, 0, 0}, {0.7f, 0.6f, 0.5f}, false);
    return mesh;
}

/// Three wings around a paved court.
inline Mesh court() {
    Mesh mesh;
    addRoom(mesh, {-6, 0, -6}, {-4, 4, 6}, false);
    addRoom(mesh, {4, 0, -6}, {6, 4, 6}, false);
    addRoom(mesh, {-4, 0, -6}, {4, 4, -4}, false);
    addQuad(mesh, {-4, 0, -4}, {-4, 0, 6}, {4, 0, 6}, {4, 0, -4});
    return mesh;
}

inline Mesh table() {
    Mesh mesh;
    addRoom(mesh, {-1, 0.9f, -0.6f}, {1, 1, 0.6f}, false);
    for (float x : {-0.9f, 0.8f})
        for (float z : {-0.5f, 0.4f}) addRoom(mesh, {x, 0, z}, {x + 0.1f, 0.9f, z + 0.1f}, false);
    return mesh;
}

/// A trunk, and cards that face everywhere.
inline Mesh tree() {
    Mesh mesh;
    addRoom(mesh, {-0.1f, 0, -0.1f}, {0.1f, 2, 0.1f}, false);
    for (int i = 0; i < 800; ++i) {
        const float y = 1 - (2.0f * (float) i + 1) / 800, turn = 2.4f * (float) i;
        const float radius = std::sqrt(1 - y * y);
        const glm::vec3 out(radius * std::cos(turn), y, radius * std::sin(turn));
        const float reach = 0.5f + 0.5f * std::fmod(0.618f * (float) i, 1.0f);
        const glm::vec3 middle = glm::vec3(0, 3, 0) + 1.5f * reach * out;
        const glm::vec3 u(0.1f * std::cos(7 * turn), 0, 0.1f * std::sin(7 * turn));
        const glm::vec3 v(-0.07f * std::sin(7 * turn), 0.07f, 0.07f * std::cos(7 * turn));
        const glm::vec3 w = i % 2 ? v : -v; // the front above, or below
        addQuad(mesh, middle - u - w, middle + u - w, middle + u + w, middle - u + w);
    }
    return mesh;
}

/// A hilly closed road.
inline Mesh track() {
    Mesh mesh;
    const int pieces = 60;
    const auto at = [&](int i, float offset) {
        const float turn = 2 * (float) std::numbers::pi * (float) i / pieces;
        return glm::vec3(2 * (100 + offset) * std::cos(turn), 3 * std::sin(3 * turn),
                         (100 + offset) * std::sin(turn));
    };
    for (int i = 0; i < pieces; ++i)
        addQuad(mesh, at(i, -8), at(i + 1, -8), at(i + 1, 8), at(i, 8));
    return mesh;
}

/// A board with a label before it on \p side: 1 towards +Z, -1 towards -Z, whence both are seen.
inline Mesh sign(float side) {
    Mesh mesh;
    addQuad(mesh, {-2 * side, -2, 0}, {2 * side, -2, 0}, {2 * side, 2, 0}, {-2 * side, 2, 0}, 0);
    const float z = 0.05f * side;
    addQuad(mesh, {-side, -1, z}, {side, -1, z}, {side, 1, z}, {-side, 1, z}, 1);
    return mesh;
}

/// Labels towards -Z, on a board of the same area that turns its front to +Z.
inline Mesh labelsBehindABoard() {
    Mesh mesh;
    addQuad(mesh, {-1, -1, 0.05f}, {1, -1, 0.05f}, {1, 1, 0.05f}, {-1, 1, 0.05f}, 0);
    uint32_t material = 0;
    for (float x : {-0.7f, 0.7f})
        for (float y : {-0.7f, 0.7f})
            addQuad(mesh, {x + 0.5f, y - 0.5f, 0}, {x - 0.5f, y - 0.5f, 0}, {x - 0.5f, y + 0.5f, 0},
                    {x + 0.5f, y + 0.5f, 0}, ++material);
    return mesh;
}

/// A house of walls and a roof, whose up is Z and whose front looks along -Y.
inline Mesh zUpHouse() {
    Mesh mesh;
    addRoom(mesh, {-4, -3, 0}, {4, 3, 3}, false, front);
    addQuad(mesh, {-4.5f, -3.5f, 3}, {4.5f, -3.5f, 3}, {4.5f, 0, 5}, {-4.5f, 0, 5});
    addQuad(mesh, {4.5f, 3.5f, 3}, {-4.5f, 3.5f, 3}, {-4.5f, 0, 5}, {4.5f, 0, 5});
    return mesh;
}

inline Mesh ballInABall() {
    Mesh mesh;
    addBall(mesh, glm::vec3(0), 1.0f, 12);
    addBall(mesh, glm::vec3(0), 0.5f, 12);
    return mesh;
}

/// Two shells that face outwards and inwards, as a case has them, and a ball in it.
inline Mesh caseWithABall() {
    Mesh mesh;
    addBall(mesh, glm::vec3(0), 0.9f, 12);
    for (Corners& t : mesh.triangles) std::swap(t[0], t[1]);
    addBall(mesh, glm::vec3(0), 1.0f, 12);
    addBall(mesh, glm::vec3(0), 0.5f, 12);
    return mesh;
}

/// A closed box whose sides are there twice, to be seen from either side. (The diagonals of their
/// quads cross: no two triangles have the same corners.)
inline void addTwoSidedBox(Mesh& mesh, glm::vec3 low, glm::vec3 high) {
    addRoom(mesh, low, high, true);
    addRoom(mesh, low, high, false);
}

inline Mesh twoSidedRoom() {
    Mesh mesh;
    addTwoSidedBox(mesh, {-3, 0, -3}, {3, 2.7f, 3});
    addRoom(mesh, {-1, 0, -1}, {1, 1, 1}, false);
    return mesh;
}

/// A tray of one layer, 2 x 1 x 2, open above, whose outside is its front.
inline Mesh tray() {
    Mesh mesh;
    addRoom(mesh, {-1, 0, -1}, {1, 1, 1}, false, top);
    return mesh;
}

/// The lower half of a ball whose inside is its front.
inline Mesh bowl() {
    Mesh mesh;
    const int around = 16, down = 8;
    const auto at = [&](int i, int j) {
        const float turn = 2 * (float) std::numbers::pi * (float) (i % around) / around;
        const float fall = 0.5f * (float) std::numbers::pi * (float) j / down;
        return glm::vec3(std::cos(fall) * std::cos(turn), -std::sin(fall),
                         std::cos(fall) * std::sin(turn));
    };
    for (int i = 0; i < around; ++i)
        for (int j = 0; j < down; ++j)
            addQuad(mesh, at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j));
    return mesh;
}

/// A closed block, grey in front and on its sides, that has a screen behind.
inline Mesh screenBehind() {
    Mesh mesh;
    addRoom(mesh, {-2, -1, -0.2f}, {2, 1, 0.2f}, false);
    addQuad(mesh, {1.8f, -0.9f, -0.21f}, {-1.8f, -0.9f, -0.21f}, {-1.8f, 0.9f, -0.21f},
            {1.8f, 0.9f, -0.21f}, 1);
    return mesh;
}

/// A square of side 2 whose front looks along \p axis, forwards or backwards.
inline Mesh square(int axis, bool forwards) {
    Mesh mesh;
    glm::vec3 u(0), v(0);
    u[(axis + 1) % 3] = forwards ? 1.0f : -1.0f;
    v[(axis + 2) % 3] = 1.0f;
    addQuad(mesh, -u - v, u - v, u + v, v - u);
    return mesh;
}

inline Mesh scaled(Mesh mesh, float scale) {
    for (glm::vec3& p : mesh.positions) p *= scale;
    return mesh;
}

/// Models of both kinds, with names.
inline std::vector<std::pair<std::string, Mesh>> objects() {
    return {{"box", box(false)},
            {"inside-out box", box(true)},
            {"hollow box", hollowBox(0.1f)},
            {"hollow box, thin", hollowBox(0.001f)},
            {"ball in a ball", ballInABall()},
            {"table", table()},
            {"tree", tree()},
            {"court", court()},
            {"track", track()},
            {"sign", sign(1)},
            {"sign behind", sign(-1)},
            {"labels behind a board", labelsBehindABoard()},
            {"case with a ball", caseWithABall()},
            {"two-sided room", twoSidedRoom()},
            {"tray", tray()},
            {"bowl", bowl()},
            {"screen behind", screenBehind()},
            {"wall", square(2, true)},
            {"wall behind", square(2, false)},
            {"floor", square(1, true)},
            {"ceiling", square(1, false)},
            {"house, Z up", zUpHouse()}};
}

inline std::vector<std::pair<std::string, Mesh>> rooms() {
    return {{"hall", hall()},
            {"open in front", openRoom(front)},
            {"open behind", openRoom(back)},
            {"open to the left", openRoom(left)},
            {"open above", openRoom(top)}};
}

} // namespace dirt::test
