#include "core/verify/extreme_triangles.h"

#include "core/grid/geometry.h"
#include "core/verify/extreme_mesh.h"
#include "core/verify/random.h"

#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

namespace dirt {

namespace {

constexpr uint32_t kMostSampled = 4096;
constexpr uint32_t kCrowd = 10'000;

/// Calls \p add(corners, positions, how many before it) for triangles of the scene as it is.
template <class Add>
void forTriangles(Scene& scene, Add&& add) {
    uint32_t count = 0;
    for (const uint32_t id : sampleTriangles(scene.mesh, kMostSampled)) {
        const Corners corners = scene.mesh.triangles[id];
        glm::vec3 p[3];
        for (int k = 0; k < 3; k++) p[k] = scene.mesh.positions[corners[k]];
        add(corners, p, count++);
    }
}

} // namespace

void addSlivers(Scene& scene) {
    const uint32_t grey = addGrey(scene);
    forTriangles(scene, [&](const Corners&, const glm::vec3* p, uint32_t) {
        const glm::dvec3 a(p[0]), b(p[1]), onEdge = a + 0.37 * (b - a);
        addTriangle(scene.mesh, a, b, onEdge + 1e-6 * (glm::dvec3(p[2]) - onEdge), grey);
    });
}

void addNeedles(Scene& scene) {
    const uint32_t grey = addGrey(scene);
    forTriangles(scene, [&](const Corners&, const glm::vec3* p, uint32_t i) {
        glm::vec3 beside = p[1];
        float& moved = beside[(int) (i % 3)];
        moved = std::nextafter(moved, std::numeric_limits<float>::max());
        addTriangle(scene.mesh, p[0], p[1], beside, grey);
    });
}

void addPoints(Scene& scene) {
    const uint32_t grey = addGrey(scene);
    forTriangles(scene, [&](const Corners& corners, const glm::vec3* p, uint32_t i) {
        if (i % 2 == 0)
            addTriangle(scene.mesh, {corners[0], corners[0], corners[0]}, grey);
        else
            addTriangle(scene.mesh, p[0], p[0], p[0], grey);
    });
}

void addRepeated(Scene& scene) {
    const uint32_t grey = addGrey(scene);
    forTriangles(scene, [&](const Corners& corners, const glm::vec3* p, uint32_t i) {
        const Corners orders[] = {{0, 1, 0}, {0, 0, 1}, {0, 1, 1}};
        const Corners& order = orders[i % 3];
        if (i % 2 == 0)
            addTriangle(scene.mesh, {corners[order[0]], corners[order[1]], corners[order[2]]},
                        grey);
        else
            addTriangle(scene.mesh, p[order[0]], p[order[1]], p[order[2]], grey);
    });
}

void addCollinear(Scene& scene) {
    const uint32_t grey = addGrey(scene);
    forTriangles(scene, [&](const Corners&, const glm::vec3* p, uint32_t i) {
        glm::vec3 end = p[0], middle = p[0];
        const int axis = (int) (i % 3);
        end[axis] = p[1][axis];
        middle[axis] = 0.5f * p[0][axis] + 0.5f * p[1][axis];
        addTriangle(scene.mesh, p[0], end, middle, grey);
    });
}

void addCoincident(Scene& scene) {
    const uint32_t grey = addGrey(scene);
    constexpr int kOrders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1},
                                   {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
    forTriangles(scene, [&](const Corners& corners, const glm::vec3*, uint32_t) {
        for (const auto& order : kOrders)
            addTriangle(scene.mesh, {corners[order[0]], corners[order[1]], corners[order[2]]},
                        grey);
    });
}

void cutEdges(Scene& scene) {
    Mesh& mesh = scene.mesh;
    for (const uint32_t id : sampleTriangles(mesh, kMostSampled)) {
        const auto [a, b, c] = mesh.triangles[id];
        const uint32_t middle =
            addVertex(mesh, 0.5f * mesh.positions[a] + 0.5f * mesh.positions[b]);
        mesh.triangles[id] = {a, middle, c};
        mesh.normalIndices[id] = mesh.texcoordIndices[id] = {kNoIndex, kNoIndex, kNoIndex};
        addTriangle(mesh, {middle, b, c}, mesh.materials[id]);
    }
}

void crowdOneBin(Scene& scene) {
    const double size = sizeOf(scene.mesh);
    const CameraBasis basis = cameraBasis(scene.camera);
    // Off the axis, where tiles may have a corner.
    const glm::dvec3 towards =
        glm::dvec3(basis.forward) + 0.13 * glm::dvec3(basis.right) + 0.07 * glm::dvec3(basis.down);
    const glm::dvec3 centre = glm::dvec3(scene.camera.eye) + 0.5 * size * towards;
    const uint32_t grey = addGrey(scene);
    for (uint32_t i = 0; i < kCrowd; i++) {
        RayRandom random(0, 0, i);
        const auto point = [&](double radius) {
            glm::dvec3 p;
            for (int k = 0; k < 3; k++) p[k] = radius * (2.0 * random.uniform() - 1.0);
            return p;
        };
        const glm::dvec3 a = centre + point(1e-3 * size);
        addTriangle(scene.mesh, a, a + point(1e-4 * size), a + point(1e-4 * size), grey);
    }
}

void coverAll(Scene& scene) {
    const Bounds bounds = boundsOf(scene.mesh);
    const CameraBasis basis = cameraBasis(scene.camera);
    const glm::dvec3 eye(scene.camera.eye), right(basis.right), down(basis.down);
    const double reach = sizeOf(scene.mesh) + glm::length(glm::max(glm::abs(bounds.low - eye),
                                                                   glm::abs(bounds.high - eye)));
    const glm::dvec3 centre = eye + reach * glm::dvec3(basis.forward);
    addTriangle(scene.mesh, centre - 2e4 * reach * right - 1e4 * reach * down,
                centre + 2e4 * reach * right - 1e4 * reach * down, centre + 2e4 * reach * down,
                addGrey(scene));
}

} // namespace dirt
