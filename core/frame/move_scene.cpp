#include "core/frame/move_scene.h"

#include "core/base/error.h"
#include "core/base/finite.h"

#include <atomic>
#include <cfloat>
#include <cmath>
#include <string>

#include <glm/geometric.hpp>
#include <glm/mat4x3.hpp>

namespace dirt {

namespace {

constexpr size_t kVerticesPerPiece = 8192;

glm::vec3 transformed(const glm::mat4x3& m, glm::vec3 p) {
    return {((m[0][0] * p.x + m[1][0] * p.y) + m[2][0] * p.z) + m[3][0],
            ((m[0][1] * p.x + m[1][1] * p.y) + m[2][1] * p.z) + m[3][1],
            ((m[0][2] * p.x + m[1][2] * p.y) + m[2][2] * p.z) + m[3][2]};
}

/// Zero, which shading takes for no normal, where the transform leaves no direction.
glm::vec3 turned(const glm::dmat3& m, glm::vec3 normal) {
    const glm::dvec3 n = m * glm::dvec3(normal);
    const double length = std::sqrt(glm::dot(n, n));
    return length > 0.0 && std::isfinite(length) ? glm::vec3(n / length) : glm::vec3(0.0f);
}

/// One moving part on its way into the mesh.
struct Move {
    const MovingPart& part;
    Mesh& mesh;
    const glm::mat4x3 toWorld;
    const glm::dmat3 normalToWorld;
    std::atomic<bool> finite{true};

    Move(const MovingPart& movingPart, Mesh& target, const glm::dmat4& matrix)
        : part(movingPart), mesh(target), toWorld(matrix),
          normalToWorld(normalMatrix(glm::dmat3(matrix))) {}

    void positions(size_t begin, size_t end) {
        bool allFinite = true;
        for (size_t i = begin; i < end; ++i) {
            const glm::vec3 p = transformed(toWorld, part.positions[i]);
            allFinite = allFinite && isFinite(p);
            mesh.positions[part.firstPosition + i] = p;
        }
        if (!allFinite) finite = false;
    }
    void normals(size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i)
            mesh.normals[part.firstNormal + i] = turned(normalToWorld, part.normals[i]);
    }
};

} // namespace

void moveScene(Scene& scene, int frame, Executor& executor) {
    const Animation& animation = scene.animation;
    const double time = animation.timeOf(frame);
    scene.camera = animation.cameraAt(scene.camera, time);
    for (const MovingPart& part : animation.parts) {
        Move move(part, scene.mesh, animation.toWorld(part, time));
        // What captures no more than a reference fits into a std::function without allocation.
        executor.forRange(part.positions.size(), kVerticesPerPiece,
                          [&move](size_t begin, size_t end) { move.positions(begin, end); });
        executor.forRange(part.normals.size(), kVerticesPerPiece,
                          [&move](size_t begin, size_t end) { move.normals(begin, end); });
        if (!move.finite)
            throw InputError("frame " + std::to_string(frame) +
                             ": a vertex that moves does not fit in float32");
    }
}

} // namespace dirt
