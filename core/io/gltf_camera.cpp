#include "core/io/gltf_camera.h"

#include "core/io/load_report.h"
#include "core/io/number.h"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace dirt {

std::vector<GltfCamera> gltfCameras(const GltfData& data) {
    std::vector<GltfCamera> cameras;
    for (const JsonValue& source : data.root().objects("cameras")) {
        GltfCamera& camera = cameras.emplace_back();
        camera.name = printable(source.text("name").value_or(""));
        camera.index = cameras.size() - 1;
        if (source.text("type") == "orthographic") {
            const JsonValue orthographic = source.required("orthographic");
            camera.halfHeight = std::abs(orthographic.number("ymag", -1e30, 1e30).value_or(0.0));
            if (*camera.halfHeight == 0.0) orthographic.fail("has no ymag");
            continue;
        }
        const JsonValue perspective = source.required("perspective");
        const auto angle = perspective.number("yfov", 0.0, std::numbers::pi);
        if (!angle || *angle == 0.0 || *angle == std::numbers::pi)
            perspective.fail("has no yfov between 0 and pi");
        camera.verticalFov = *angle * 180.0 / std::numbers::pi;
    }
    return cameras;
}

Camera GltfCamera::placed(const glm::dmat4& toWorld, const std::filesystem::path& file) const {
    const glm::dmat4 matrix = toWorld * toFile;
    const glm::dvec3 eye(matrix[3]), up(matrix[1]), backward(matrix[2]);
    // As far away as the origin: so float32 has as many digits for the direction as for the eye.
    const double far = glm::length(eye) > 0.0 ? glm::length(eye) : 1.0;
    const glm::dvec3 target = eye - far * glm::normalize(backward);
    // A scale that is no rotation may have bent the axes; the view's direction is kept.
    const glm::dvec3 upward = glm::normalize(up);
    if (!fitsFloat(eye) || !fitsFloat(target) || !fitsFloat(upward) ||
        !(glm::length(glm::cross(upward, target - eye)) > 0.0))
        failAt(file, 0, "cameras[" + std::to_string(index) + "] has no place or no direction");
    Camera camera;
    camera.eye = glm::vec3(eye);
    camera.target = glm::vec3(target);
    camera.up = glm::vec3(upward);
    camera.verticalFov = (float) verticalFov;
    return camera;
}

} // namespace dirt
