#include "core/verify/extreme_bodies.h"

#include "core/verify/extreme_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <glm/geometric.hpp>

namespace dirt {

namespace {

/// As bright as a surface at \p distance is under a radiance of about 1.
Spotlight lightAt(const glm::dvec3& position, const glm::dvec3& target) {
    Spotlight light;
    light.position = glm::vec3(position), light.target = glm::vec3(target);
    light.aperture = 120.0f, light.penumbra = 100.0f;
    const double distance = glm::distance(position, target);
    light.flux = (float) (10.0 * distance * distance);
    return light;
}

void lookFrom(Camera& camera, const glm::dvec3& eye, const glm::dvec3& target) {
    camera.eye = glm::vec3(eye), camera.target = glm::vec3(target);
    camera.up = {0.0f, 1.0f, 0.0f};
    camera.apertureRadius = 0.0f;
}

/// Walls in the order of Room: axis by axis, low before high.
void addWall(Scene& scene, int axis, double at, const Bounds& room, double margin,
             uint32_t material) {
    const int i = (axis + 1) % 3, j = (axis + 2) % 3;
    uint32_t corners[4];
    for (int k = 0; k < 4; k++) {
        glm::dvec3 p;
        p[axis] = at;
        p[i] = k & 1 ? room.high[i] + margin : room.low[i] - margin;
        p[j] = k & 2 ? room.high[j] + margin : room.low[j] - margin;
        corners[k] = addVertex(scene.mesh, glm::vec3(p));
    }
    addTriangle(scene.mesh, {corners[0], corners[1], corners[3]}, material);
    addTriangle(scene.mesh, {corners[0], corners[3], corners[2]}, material);
}

void addSharedWalls(Scene& scene, const Bounds& room, uint32_t material) {
    uint32_t corners[8];
    for (int k = 0; k < 8; k++)
        corners[k] = addVertex(scene.mesh,
                               {k & 1 ? room.high.x : room.low.x, k & 2 ? room.high.y : room.low.y,
                                k & 4 ? room.high.z : room.low.z});
    for (int axis = 0; axis < 3; axis++)
        for (const int side : {0, 1}) {
            const int base = side << axis, i = 1 << (axis + 1) % 3, j = 1 << (axis + 2) % 3;
            addTriangle(scene.mesh, {corners[base], corners[base + i], corners[base + i + j]},
                        material);
            addTriangle(scene.mesh, {corners[base], corners[base + i + j], corners[base + j]},
                        material);
        }
}

} // namespace

void encloseInBox(Scene& scene, bool shared) {
    const double size = sizeOf(scene.mesh);
    Bounds room = boundsOf(scene.mesh);
    room.low -= 0.125 * size, room.high += 0.125 * size;
    for (Material& material : scene.materials) {
        material.emission = glm::vec3(0.0f);
        material.emissionMap = kNoTexture;
    }
    const uint32_t grey = addGrey(scene);
    if (shared)
        addSharedWalls(scene, room, grey);
    else
        for (int axis = 0; axis < 3; axis++)
            for (const double at : {room.low[axis], room.high[axis]})
                addWall(scene, axis, at, room, 0.25 * size, grey);

    const glm::dvec3 centre = 0.5 * (room.low + room.high);
    lookFrom(scene.camera, centre + 0.01 * size * glm::dvec3(1.0, 2.0, 3.0), room.high);
    scene.lights = {lightAt(centre + size * glm::dvec3(1.3, 2.1, 0.9), centre)};
    scene.background = glm::vec3(1.0f);
}

Room roomOf(const Mesh& mesh) {
    Room room;
    const size_t first = mesh.triangles.size() - 12;
    for (int axis = 0; axis < 3; axis++) {
        const auto wall = [&](int side) {
            const Corners& corners = mesh.triangles[first + 4 * (size_t) axis + 2 * (size_t) side];
            return mesh.positions[corners[0]][axis];
        };
        room.low[axis] = wall(0), room.high[axis] = wall(1);
    }
    return room;
}

void replaceByBall(Scene& scene) {
    const Bounds bounds = boundsOf(scene.mesh);
    const double radius = sizeOf(scene.mesh);
    const glm::dvec3 centre = 0.5 * (bounds.low + bounds.high);
    scene.mesh = {};
    const uint32_t grey = addGrey(scene);

    // An icosahedron, each face cut in four.
    const double g = 0.5 * (1.0 + std::sqrt(5.0));
    std::vector<glm::dvec3> points{{-1, g, 0}, {1, g, 0}, {-1, -g, 0}, {1, -g, 0},
                                   {0, -1, g}, {0, 1, g}, {0, -1, -g}, {0, 1, -g},
                                   {g, 0, -1}, {g, 0, 1}, {-g, 0, -1}, {-g, 0, 1}};
    constexpr uint32_t kFaces[20][3] = {
        {0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
        {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
        {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
    std::map<std::pair<uint32_t, uint32_t>, uint32_t> middles;
    const auto middle = [&](uint32_t a, uint32_t b) {
        const auto [entry, isNew] =
            middles.try_emplace(std::minmax(a, b), (uint32_t) points.size());
        if (isNew) points.push_back(0.5 * (points[a] + points[b]));
        return entry->second;
    };
    for (const auto& [a, b, c] : kFaces) {
        const uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
        for (const Corners& corners :
             {Corners{a, ab, ca}, Corners{b, bc, ab}, Corners{c, ca, bc}, Corners{ab, bc, ca}})
            addTriangle(scene.mesh, corners, grey);
    }
    for (const glm::dvec3& p : points)
        addVertex(scene.mesh, glm::vec3(centre + radius * glm::normalize(p)));
    lookFrom(scene.camera, centre + 3.0 * radius * glm::dvec3(0.48, 0.6, 0.64), centre);
    scene.lights = {lightAt(centre + 4.0 * radius * glm::dvec3(-0.3, 0.5, 0.7), centre)};
    scene.animation = {};
}

} // namespace dirt
