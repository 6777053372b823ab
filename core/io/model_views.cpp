#include "core/io/model_views.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <glm/geometric.hpp>

namespace dirt {

void placeModelViews(const Model& model, const glm::dmat4& toWorld, LoadReport& report,
                     std::vector<ModelCamera>& cameras, std::vector<Spotlight>& lights) {
    const auto* gltf = std::get_if<GltfFile>(&model.file);
    if (gltf == nullptr) return;
    for (const GltfCamera& source : gltf->cameras)
        cameras.push_back({source.name, source.placed(toWorld, gltf->file), source.halfHeight});
    if (!gltf->spotlight) return;
    if (lights.empty())
        lights.push_back(gltf->spotlight->placed(toWorld, gltf->file));
    else
        report.ignore("glTF light of type spot beside another light");
}

Camera fromAfar(const ModelCamera& source, const Mesh& mesh) {
    constexpr double kTimes = 16.0;
    const glm::dvec3 eye(source.camera.eye);
    const glm::dvec3 forward = glm::normalize(glm::dvec3(source.camera.target) - eye);
    double nearest = std::numeric_limits<double>::max(), farthest = -nearest;
    for (const glm::vec3& p : mesh.positions) {
        const double depth = glm::dot(glm::dvec3(p) - eye, forward);
        nearest = std::min(nearest, depth);
        farthest = std::max(farthest, depth);
    }
    const double half = 0.5 * (farthest - nearest);
    const double distance = kTimes * std::max(*source.halfHeight, half);
    const glm::dvec3 middle = eye + 0.5 * (nearest + farthest) * forward;
    Camera camera = source.camera;
    camera.eye = glm::vec3(middle - distance * forward);
    camera.target = glm::vec3(middle);
    camera.verticalFov =
        (float) (std::atan(*source.halfHeight / distance) * 360.0 / std::numbers::pi);
    return camera;
}

} // namespace dirt
