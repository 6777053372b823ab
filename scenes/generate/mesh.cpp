#include "scenes/generate/mesh.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat3x3.hpp>

namespace dirt::generate {
namespace {

Vec3 unitOr(Vec3 vector, Vec3 fallback) {
    const double length = glm::length(vector);
    return length > 0 ? vector / length : fallback;
}

} // namespace

std::vector<std::uint32_t>& Mesh::trianglesOf(int material) {
    const auto index = static_cast<std::size_t>(material);
    if (triangles_.size() <= index) {
        triangles_.resize(index + 1);
    }
    return triangles_[index];
}

std::uint32_t Mesh::addVertex(Vec3 position, Vec3 normal, Vec2 texcoord) {
    if (detail_.countOnly) {
        return 0;
    }
    vertices_.push_back({glm::vec3(position), glm::vec3(normal), glm::vec2(texcoord)});
    return static_cast<std::uint32_t>(vertices_.size() - 1);
}

void Mesh::addTriangle(int material, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (detail_.countOnly) {
        ++count_;
        return;
    }
    // Poles of patches collapse to a point: judged on the rounded positions, which are what counts.
    const Vec3 origin(vertices_[a].position);
    const Vec3 cross =
        glm::cross(Vec3(vertices_[b].position) - origin, Vec3(vertices_[c].position) - origin);
    if (glm::dot(cross, cross) < 1e-18) {
        return;
    }
    ++count_;
    auto& list = trianglesOf(material);
    list.insert(list.end(), {a, b, c});
}

void Mesh::addPatch(int material, int columns, int rows, const Surface& surface,
                    PatchOptions options) {
    if (detail_.countOnly) {
        count_ += 2 * static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
        return;
    }
    const int stride = columns + 1;
    const auto at = [stride](int i, int j) {
        return static_cast<std::size_t>(j) * static_cast<std::size_t>(stride) +
               static_cast<std::size_t>(i);
    };
    std::vector<SurfacePoint> points(static_cast<std::size_t>(stride * (rows + 1)));
    for (int j = 0; j <= rows; ++j) {
        for (int i = 0; i <= columns; ++i) {
            points[at(i, j)] =
                surface(static_cast<double>(i) / columns, static_cast<double>(j) / rows);
        }
    }
    std::vector<Vec3> normals(points.size(), Vec3(0));
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < columns; ++i) {
            const Vec3 diagonal = points[at(i + 1, j + 1)].position - points[at(i, j)].position;
            const Vec3 other = points[at(i, j + 1)].position - points[at(i + 1, j)].position;
            const Vec3 normal = glm::cross(diagonal, other) * (options.flip ? -1.0 : 1.0);
            for (const auto corner : {at(i, j), at(i + 1, j), at(i, j + 1), at(i + 1, j + 1)}) {
                normals[corner] += normal;
            }
        }
    }
    if (options.wrapU) {
        for (int j = 0; j <= rows; ++j) {
            normals[at(0, j)] = normals[at(columns, j)] =
                normals[at(0, j)] + normals[at(columns, j)];
        }
    }
    if (options.wrapV) {
        for (int i = 0; i <= columns; ++i) {
            normals[at(i, 0)] = normals[at(i, rows)] = normals[at(i, 0)] + normals[at(i, rows)];
        }
    }
    const auto base = static_cast<std::uint32_t>(vertices_.size());
    for (std::size_t k = 0; k < points.size(); ++k) {
        addVertex(points[k].position, unitOr(normals[k], Vec3(0, 1, 0)), points[k].texcoord);
    }
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < columns; ++i) {
            const auto a = base + static_cast<std::uint32_t>(at(i, j));
            const auto b = a + 1;
            const auto d = base + static_cast<std::uint32_t>(at(i, j + 1));
            const auto c = d + 1;
            if (options.flip) {
                addTriangle(material, a, c, b);
                addTriangle(material, a, d, c);
            } else {
                addTriangle(material, a, b, c);
                addTriangle(material, a, c, d);
            }
        }
    }
}

void Mesh::addQuad(int material, Vec3 a, Vec3 b, Vec3 c, Vec3 d, Vec2 texcoordShift) {
    const Vec3 normal = unitOr(glm::cross(c - a, d - b), Vec3(0, 1, 0));
    const Vec3 right = unitOr(b - a, Vec3(1, 0, 0));
    const Vec3 up = glm::cross(normal, right);
    std::uint32_t index[4];
    const Vec3 corners[4] = {a, b, c, d};
    for (int k = 0; k < 4; ++k) {
        const Vec3 offset = corners[k] - a;
        const Vec2 texcoord(glm::dot(offset, right), glm::dot(offset, up));
        index[k] = addVertex(corners[k], normal, texcoord + texcoordShift);
    }
    addTriangle(material, index[0], index[1], index[2]);
    addTriangle(material, index[0], index[2], index[3]);
}

void Mesh::append(const Mesh& part, const Transform& transform, Vec2 texcoordShift) {
    if (detail_.countOnly) {
        count_ += part.count_;
        return;
    }
    const glm::dmat3 linear(transform);
    const bool mirrored = glm::determinant(linear) < 0;
    const glm::dmat3 normalMatrix = glm::transpose(glm::inverse(linear));
    const auto base = static_cast<std::uint32_t>(vertices_.size());
    for (const Vertex& vertex : part.vertices_) {
        addVertex(Vec3(transform * glm::dvec4(Vec3(vertex.position), 1)),
                  unitOr(normalMatrix * Vec3(vertex.normal), Vec3(0, 1, 0)),
                  Vec2(vertex.texcoord) + texcoordShift);
    }
    for (std::size_t material = 0; material < part.triangles_.size(); ++material) {
        const auto& list = part.triangles_[material];
        for (std::size_t k = 0; k < list.size(); k += 3) {
            addTriangle(static_cast<int>(material), base + list[k],
                        base + list[k + (mirrored ? 2 : 1)], base + list[k + (mirrored ? 1 : 2)]);
        }
    }
}

Transform place(Vec3 position, double degrees) {
    return glm::rotate(glm::translate(Transform(1), position), glm::radians(degrees),
                       Vec3(0, 1, 0));
}

Transform scaled(Vec3 factors) {
    return glm::scale(Transform(1), factors);
}

} // namespace dirt::generate
