#include "core/io/scene_origin.h"

#include <glm/vec4.hpp>

namespace dirt {

namespace {

std::vector<bool> usedPositions(const ObjFile& obj) {
    std::vector<bool> used(obj.positions.size(), false);
    for (const ObjFile::Corner& corner : obj.corners) used[corner.position] = true;
    return used;
}

std::vector<bool> usedPositions(const GltfFile::Primitive& primitive) {
    std::vector<bool> used(primitive.positions.size(), false);
    for (const auto& triangle : primitive.triangles)
        for (const uint32_t vertex : triangle) used[vertex] = true;
    return used;
}

template <typename Vector>
void includePoints(const std::vector<Vector>& points, const std::vector<bool>& used,
                   const glm::dmat4& matrix, Bounds& bounds) {
    for (size_t i = 0; i < points.size(); ++i)
        if (used[i]) bounds.include(glm::dvec3(matrix * glm::dvec4(points[i], 1.0)));
}

void takeOff(const glm::dvec3& origin, Track<glm::dvec3>& track) {
    for (auto& key : track.keys) key.value -= origin;
}

} // namespace

ModelPoints::ModelPoints(const Model& model) : model_(model) {
    if (const auto* obj = std::get_if<ObjFile>(&model.file))
        used_.push_back(usedPositions(*obj));
    else if (const auto* gltf = std::get_if<GltfFile>(&model.file))
        for (const auto& mesh : gltf->meshes)
            for (const GltfFile::Primitive& primitive : mesh)
                used_.push_back(usedPositions(primitive));
}

void ModelPoints::include(const glm::dmat4& matrix, Bounds& bounds) const {
    if (const auto* obj = std::get_if<ObjFile>(&model_.file))
        includePoints(obj->positions, used_.front(), matrix, bounds);
    const auto* gltf = std::get_if<GltfFile>(&model_.file);
    if (!gltf) return;
    std::vector<size_t> first; // of each mesh's primitives, in used_
    size_t primitives = 0;
    for (const auto& mesh : gltf->meshes) {
        first.push_back(primitives);
        primitives += mesh.size();
    }
    for (const GltfFile::Instance& instance : gltf->instances) {
        const auto& mesh = gltf->meshes[instance.mesh];
        for (size_t i = 0; i < mesh.size(); ++i)
            includePoints(mesh[i].positions, used_[first[instance.mesh] + i],
                          matrix * instance.toFile, bounds);
    }
}

void OriginFinder::add(const Model& model, const glm::dmat4& toSpace, uint32_t space) {
    const ModelPoints& points = points_.try_emplace(&model, model).first->second;
    if (space == MovingSpace::kWorld) {
        points.include(toSpace, world_);
        moving_.push_back(std::nullopt);
        return;
    }
    points.include(animation_.toWorld(space, 0.0) * toSpace, world_);
    Bounds own;
    points.include(toSpace, own);
    moving_.push_back(originFor(own));
}

glm::dvec3 OriginFinder::ofSpace(size_t index) const {
    return moving_[index] ? *moving_[index] : ofWorld();
}

glm::dmat4 relativeTo(const glm::dvec3& origin, glm::dmat4 matrix) {
    matrix[3] -= glm::dvec4(origin, 0.0);
    return matrix;
}

void moveToOrigin(const SceneFile& source, Scene& scene) {
    const glm::dvec3& origin = scene.origin;
    const SceneFile::Points& points = source.points;
    Camera& camera = scene.camera;
    if (source.hasCamera) {
        camera.eye = scene.fromFiles(points.eye);
        camera.target = points.target ? scene.fromFiles(*points.target)
                                      : camera.eye + glm::vec3(0.0f, 0.0f, -1.0f);
        if (points.userLine > 0 && camera.eye == camera.target)
            failAt(source.file, points.userLine, "<user>: position and lookat are the same point");
    }
    if (source.light) {
        Spotlight& light = scene.lights.front();
        light.position = scene.fromFiles(points.lightPosition);
        light.target = scene.fromFiles(points.lightTarget);
        if (light.position == light.target)
            failAt(source.file, points.lightLine,
                   "<light>: position and target are the same point");
    }
    if (scene.animation.camera) {
        takeOff(origin, scene.animation.camera->eye);
        takeOff(origin, scene.animation.camera->target);
    }
    for (MovingSpace& space : scene.animation.spaces)
        if (space.parent == MovingSpace::kWorld)
            space.toParent = relativeTo(origin, space.toParent);
}

} // namespace dirt
