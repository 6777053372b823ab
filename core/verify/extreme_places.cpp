#include "core/verify/extreme_places.h"

#include "core/grid/geometry.h"
#include "core/verify/extreme_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

namespace dirt {

namespace {

/// The camera at \p eye, with the direction it has.
void standAt(Camera& camera, const glm::dvec3& eye) {
    glm::dvec3 ahead = glm::dvec3(camera.target) - glm::dvec3(camera.eye);
    camera.eye = glm::vec3(eye);
    // Far enough away that rounding leaves most of the direction.
    const double reach = 4.0 * glm::length(eye) + glm::length(ahead);
    ahead *= reach / glm::length(ahead);
    camera.target = glm::vec3(glm::dvec3(camera.eye) + ahead);
}

/// Likewise for a light that moves by \p offset.
void moveLight(Spotlight& light, const glm::dvec3& offset) {
    Camera along;
    along.eye = light.position, along.target = light.target;
    if (light.position == light.target) along.target.y -= 1.0f;
    standAt(along, glm::dvec3(light.position) + offset);
    light.position = along.eye, light.target = along.target;
}

void moveBy(Scene& scene, const glm::dvec3& offset) {
    for (glm::vec3& p : scene.mesh.positions) p = glm::vec3(glm::dvec3(p) + offset);
    for (Spotlight& light : scene.lights) moveLight(light, offset);
    standAt(scene.camera, glm::dvec3(scene.camera.eye) + offset);
}

/// The corners of one triangle on a lattice: multiples of `unit`, small enough that sums and
/// differences of a dozen are floats.
struct LatticeTriangle {
    Corners corners;
    std::array<glm::dvec3, 3> p;
    double unit;
};

glm::dvec3 onLattice(const glm::dvec3& p, double unit) {
    return glm::round(p / unit) * unit;
}

double largest(const glm::dvec3& p) {
    return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
}

/// Rounds the corners of a triangle from the middle of the mesh; one that keeps an area, where any
/// of a thousand does.
LatticeTriangle roundOne(Scene& scene) {
    Mesh& mesh = scene.mesh;
    LatticeTriangle found;
    const size_t count = mesh.triangles.size();
    for (size_t i = 0; i < std::min<size_t>(count, 1000); i++) {
        found.corners = mesh.triangles[(count / 2 + i) % count];
        double reach = largest(scene.camera.eye);
        for (int k = 0; k < 3; k++) {
            found.p[k] = mesh.positions[found.corners[k]];
            reach = std::max(reach, largest(found.p[k]));
        }
        int exponent = 0;
        std::frexp(reach, &exponent);
        // Below 2^18 units each: 2^6 times as much is still a float.
        found.unit = std::ldexp(1.0, exponent - 18);
        for (glm::dvec3& p : found.p) p = onLattice(p, found.unit);
        if (glm::cross(found.p[1] - found.p[0], found.p[2] - found.p[0]) != glm::dvec3(0.0)) break;
    }
    return found;
}

/// Two axes in which the triangle has an area, if it has any.
std::pair<int, int> axesOfArea(const LatticeTriangle& triangle) {
    const glm::dvec3 normal =
        glm::abs(glm::cross(triangle.p[1] - triangle.p[0], triangle.p[2] - triangle.p[0]));
    if (normal.x >= std::max(normal.y, normal.z)) return {1, 2};
    return normal.z >= normal.y ? std::pair{1, 0} : std::pair{0, 2};
}

void put(Scene& scene, const LatticeTriangle& triangle) {
    for (int k = 0; k < 3; k++)
        scene.mesh.positions[triangle.corners[k]] = glm::vec3(triangle.p[k]);
}

} // namespace

void scaleAll(Scene& scene, double factor) {
    const auto scale = [&](glm::vec3& p) { p = glm::vec3(glm::dvec3(p) * factor); };
    const auto scaleLength = [&](float& length) { length = (float) (length * factor); };
    for (glm::vec3& p : scene.mesh.positions) scale(p);
    scale(scene.camera.eye);
    scale(scene.camera.target);
    scaleLength(scene.camera.apertureRadius);
    scaleLength(scene.camera.focalDistance);
    for (Spotlight& light : scene.lights) {
        scale(light.position);
        scale(light.target);
        scaleLength(light.nearRange);
        scaleLength(light.farRange);
        light.flux = (float) (light.flux * factor * factor);
    }
}

void moveAway(Scene& scene, double sizes) {
    // Of the largest component 1, all three different.
    moveBy(scene, sizes * sizeOf(scene.mesh) * glm::dvec3(1.0, -0.7, 0.4));
}

void standOnVertex(Scene& scene) {
    const Mesh& mesh = scene.mesh;
    standAt(scene.camera, mesh.positions[mesh.triangles[mesh.triangles.size() / 2][0]]);
}

void standOnEdge(Scene& scene) {
    const LatticeTriangle triangle = roundOne(scene);
    put(scene, triangle);
    standAt(scene.camera, 0.5 * (triangle.p[0] + triangle.p[1]));
}

void standOnTriangle(Scene& scene) {
    const LatticeTriangle triangle = roundOne(scene);
    put(scene, triangle);
    standAt(scene.camera, 0.25 * (triangle.p[0] + triangle.p[1]) + 0.5 * triangle.p[2]);
}

void standInPlane(Scene& scene) {
    const LatticeTriangle triangle = roundOne(scene);
    put(scene, triangle);
    standAt(scene.camera, triangle.p[1] + triangle.p[2] - triangle.p[0]);
}

void standOnBorder(Scene& scene, GridSettings& grid, double slope) {
    grid.mode = ViewMode::full;
    grid.viewSize = 64;
    grid.tile = 16;
    LatticeTriangle triangle = roundOne(scene);
    const glm::dvec3 eye = onLattice(scene.camera.eye, triangle.unit);
    const auto [i, j] = axesOfArea(triangle);
    for (glm::dvec3& p : triangle.p) {
        const double y = p[i], z = p[j];
        p = {eye.x + slope * (z - eye.z), y, z};
    }
    put(scene, triangle);
    standAt(scene.camera, eye);
}

void standOnFaceDiagonal(Scene& scene, GridSettings& grid) {
    standOnBorder(scene, grid, 1.0);
    const glm::dvec3 eye = scene.camera.eye;
    const Corners& corners = scene.mesh.triangles[scene.mesh.triangles.size() / 3];
    glm::vec3& p = scene.mesh.positions[corners[0]];
    int exponent = 0;
    std::frexp(std::max(largest(p), largest(eye)), &exponent);
    const double along = onLattice(glm::dvec3(p) - eye, std::ldexp(1.0, exponent - 18)).z;
    p = glm::vec3(eye + glm::dvec3(along));
}

void addNear(Scene& scene) {
    const double size = sizeOf(scene.mesh);
    moveBy(scene, -glm::dvec3(scene.camera.eye));
    const CameraBasis basis = cameraBasis(scene.camera);
    const glm::dvec3 ahead(basis.forward), right(basis.right), down(basis.down);
    const uint32_t grey = addGrey(scene);
    for (const double distance : {1e-8 * size, 1e-6 * size, 1e-4 * size, 1e-2 * size}) {
        const glm::dvec3 centre = distance * (ahead + 0.03 * right);
        addTriangle(scene.mesh, centre - 0.1 * distance * right,
                    centre + distance * (0.1 * right + 0.05 * ahead),
                    centre + distance * (0.1 * down - 0.05 * ahead), grey);
    }
}

void addFar(Scene& scene) {
    const double size = sizeOf(scene.mesh);
    const CameraBasis basis = cameraBasis(scene.camera);
    const glm::dvec3 eye(scene.camera.eye), ahead(basis.forward), right(basis.right),
        down(basis.down);
    const uint32_t grey = addGrey(scene);
    for (const double distance : {1e8 * size, 1e6 * size, 1e4 * size})
        for (const double side : {1.0, -1.0}) {
            const glm::dvec3 centre = eye + side * distance * (ahead + 0.2 * right);
            addTriangle(scene.mesh, centre - distance * right, centre + distance * (right + ahead),
                        centre + distance * (down - 0.5 * ahead), grey);
        }
}

} // namespace dirt
