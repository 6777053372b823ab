#include "scenes/generate/block.h"

#include <algorithm>

#include <glm/geometric.hpp>

namespace dirt::generate {
namespace {

/// The vertex of corner (sx, sy, sz in 0, 1) that belongs to the face across `axis`.
int slot(int corner, int axis) {
    return corner * 3 + axis;
}

void orientedTriangle(Mesh& mesh, int material, const std::uint32_t* index, const Vec3* position,
                      Vec3 centre, int a, int b, int c) {
    const Vec3 normal = glm::cross(position[b] - position[a], position[c] - position[a]);
    if (glm::dot(normal, position[a] - centre) < 0) {
        std::swap(b, c);
    }
    mesh.addTriangle(material, index[a], index[b], index[c]);
}

} // namespace

void addBlock(Mesh& mesh, int material, Vec3 low, Vec3 high, double bevel, Vec2 texcoordShift) {
    const Vec3 size = high - low;
    // Wider bevels show from farther, so they come first.
    const double inset = bevel > 0 && mesh.detail().shows(0.30 - 4 * bevel)
                             ? std::min({bevel, 0.4 * size.x, 0.4 * size.y, 0.4 * size.z})
                             : 0.0;
    const Vec3 centre = (low + high) * 0.5;
    Vec3 position[24];
    std::uint32_t index[24];
    for (int corner = 0; corner < 8; ++corner) {
        for (int axis = 0; axis < 3; ++axis) {
            Vec3 p;
            Vec3 normal(0);
            for (int k = 0; k < 3; ++k) {
                const bool far = (corner >> k & 1) != 0;
                const double pull = k == axis ? 0 : inset;
                p[k] = far ? high[k] - pull : low[k] + pull;
            }
            normal[axis] = (corner >> axis & 1) != 0 ? 1 : -1;
            const Vec2 texcoord = axis == 1 ? Vec2(p.x, p.z) : Vec2(axis == 0 ? p.z : p.x, p.y);
            const int k = slot(corner, axis);
            position[k] = p;
            index[k] = mesh.addVertex(p, normal, texcoord + texcoordShift);
        }
    }
    const auto quad = [&](int a, int b, int c, int d) {
        orientedTriangle(mesh, material, index, position, centre, a, b, c);
        orientedTriangle(mesh, material, index, position, centre, a, c, d);
    };
    for (int axis = 0; axis < 3; ++axis) {
        const int first = 1 << (axis + 1) % 3;
        const int second = 1 << (axis + 2) % 3;
        for (int side = 0; side < 2; ++side) {
            const int corner = side << axis;
            quad(slot(corner, axis), slot(corner | first, axis),
                 slot(corner | first | second, axis), slot(corner | second, axis));
        }
    }
    if (inset <= 0) {
        return;
    }
    for (int axis = 0; axis < 3; ++axis) { // the four edges parallel to each axis
        const int other = (axis + 1) % 3;
        const int third = (axis + 2) % 3;
        for (int k = 0; k < 4; ++k) {
            const int corner = (k & 1) << other | (k >> 1) << third;
            const int end = corner | 1 << axis;
            quad(slot(corner, other), slot(corner, third), slot(end, third), slot(end, other));
        }
    }
    for (int corner = 0; corner < 8; ++corner) {
        orientedTriangle(mesh, material, index, position, centre, slot(corner, 0), slot(corner, 1),
                         slot(corner, 2));
    }
}

} // namespace dirt::generate
