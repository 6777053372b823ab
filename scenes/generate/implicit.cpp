#include "scenes/generate/implicit.h"

#include <cmath>

#include <glm/geometric.hpp>

namespace dirt::generate {
namespace {

struct Lattice {
    int count[3];
    Vec3 low;
    double cell;

    std::size_t index(int i, int j, int k) const {
        return (static_cast<std::size_t>(k) * static_cast<std::size_t>(count[1]) +
                static_cast<std::size_t>(j)) *
                   static_cast<std::size_t>(count[0]) +
               static_cast<std::size_t>(i);
    }
    Vec3 at(int i, int j, int k) const { return low + cell * Vec3(i, j, k); }
};

Vec3 gradient(const Solid& solid, Vec3 p, double h) {
    return {solid(p + Vec3(h, 0, 0)) - solid(p - Vec3(h, 0, 0)),
            solid(p + Vec3(0, h, 0)) - solid(p - Vec3(0, h, 0)),
            solid(p + Vec3(0, 0, h)) - solid(p - Vec3(0, 0, h))};
}

/// The middle of the points where the surface crosses the edges of a cell.
bool cellPoint(const Lattice& lattice, const std::vector<float>& values, int i, int j, int k,
               Vec3& point) {
    double value[8];
    for (int corner = 0; corner < 8; ++corner) {
        value[corner] =
            values[lattice.index(i + (corner & 1), j + (corner >> 1 & 1), k + (corner >> 2 & 1))];
    }
    Vec3 sum(0);
    int crossings = 0;
    for (int corner = 0; corner < 8; ++corner) {
        for (int axis = 0; axis < 3; ++axis) {
            const int other = corner | 1 << axis;
            if (other == corner || (value[corner] < 0) == (value[other] < 0)) continue;
            Vec3 p(corner & 1, corner >> 1 & 1, corner >> 2 & 1);
            p[axis] = value[corner] / (value[corner] - value[other]);
            sum += p;
            ++crossings;
        }
    }
    if (crossings == 0) return false;
    point = lattice.at(i, j, k) + lattice.cell * sum / static_cast<double>(crossings);
    return true;
}

} // namespace

double smoothUnion(double a, double b, double radius) {
    const double h = std::max(radius - std::abs(a - b), 0.0) / radius;
    return std::min(a, b) - h * h * radius * 0.25;
}

void addSolid(Mesh& mesh, int material, const Solid& solid, const SolidBox& box) {
    const double cell = box.cell / std::max(mesh.detail().quality, 0.05);
    if (mesh.detail().countOnly) {
        // A plane square to an axis has 2 triangles a cell's face; on average it is 1.5 times that.
        const auto count = static_cast<std::size_t>(3 * box.area / (cell * cell));
        for (std::size_t k = 0; k < count; ++k) mesh.addTriangle(material, 0, 0, 0);
        return;
    }
    Lattice lattice{{}, box.low, cell};
    for (int axis = 0; axis < 3; ++axis) {
        lattice.count[axis] = static_cast<int>((box.high[axis] - box.low[axis]) / cell) + 2;
    }
    const auto [nx, ny, nz] = lattice.count;
    std::vector<float> values(lattice.index(nx - 1, ny - 1, nz - 1) + 1);
    for (int k = 0; k < nz; ++k) {
        for (int j = 0; j < ny; ++j) {
            for (int i = 0; i < nx; ++i) {
                values[lattice.index(i, j, k)] = static_cast<float>(solid(lattice.at(i, j, k)));
            }
        }
    }
    struct Point {
        Vec3 position;
        Vec3 normal;
        std::uint32_t vertex[3]; ///< one for each plane of texture coordinates
    };
    constexpr auto none = ~0u;
    std::vector<std::uint32_t> found(values.size(), none);
    std::vector<Point> points;
    for (int k = 0; k + 1 < nz; ++k) {
        for (int j = 0; j + 1 < ny; ++j) {
            for (int i = 0; i + 1 < nx; ++i) {
                Vec3 p;
                if (!cellPoint(lattice, values, i, j, k, p)) continue;
                const Vec3 slope = gradient(solid, p, 0.3 * cell);
                const double length = glm::length(slope);
                found[lattice.index(i, j, k)] = static_cast<std::uint32_t>(points.size());
                points.push_back(
                    {p, length > 0 ? slope / length : Vec3(0, 1, 0), {none, none, none}});
            }
        }
    }
    const auto vertex = [&](std::uint32_t point, int axis) {
        Point& p = points[point];
        if (p.vertex[axis] == none) {
            const Vec2 texcoord = axis == 0   ? Vec2(p.position.z, p.position.y)
                                  : axis == 1 ? Vec2(p.position.x, p.position.z)
                                              : Vec2(p.position.x, p.position.y);
            p.vertex[axis] = mesh.addVertex(p.position, p.normal, texcoord);
        }
        return p.vertex[axis];
    };
    for (int k = 1; k + 1 < nz; ++k) {
        for (int j = 1; j + 1 < ny; ++j) {
            for (int i = 1; i + 1 < nx; ++i) {
                const bool inside = values[lattice.index(i, j, k)] < 0;
                for (int axis = 0; axis < 3; ++axis) {
                    const int next[3] = {i + (axis == 0), j + (axis == 1), k + (axis == 2)};
                    if (inside == (values[lattice.index(next[0], next[1], next[2])] < 0)) continue;
                    const int b = (axis + 1) % 3;
                    const int c = (axis + 2) % 3;
                    std::uint32_t corner[4];
                    Vec3 normal(0);
                    for (int q = 0; q < 4; ++q) { // the four cells around the edge
                        int at[3] = {i, j, k};
                        at[b] -= q == 0 || q == 3;
                        at[c] -= q == 0 || q == 1;
                        corner[q] = found[lattice.index(at[0], at[1], at[2])];
                        normal += points[corner[q]].normal;
                    }
                    normal = glm::abs(normal);
                    const int plane = normal.x > normal.y ? (normal.x > normal.z ? 0 : 2)
                                                          : (normal.y > normal.z ? 1 : 2);
                    std::uint32_t v[4];
                    for (int q = 0; q < 4; ++q) v[q] = vertex(corner[q], plane);
                    mesh.addTriangle(material, v[0], v[inside ? 1 : 2], v[inside ? 2 : 1]);
                    mesh.addTriangle(material, v[0], v[inside ? 2 : 3], v[inside ? 3 : 2]);
                }
            }
        }
    }
}

} // namespace dirt::generate
