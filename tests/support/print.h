#pragma once

#include "core/grid/geometry.h"
#include "core/trace/ray.h"
#include "tests/support/views.h"

#include <cstdio>
#include <string>

/// Failures as C++ source, in hexadecimal floats: pasted into a unit test they are the same bits.
namespace dirt::test {

inline std::string hex(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%a", value);
    return text;
}

inline std::string hex(glm::vec3 p) {
    return "{" + hex(p.x) + "f, " + hex(p.y) + "f, " + hex(p.z) + "f}";
}

inline std::string hex(const Triangle& triangle) {
    return "Triangle{" + hex(triangle.a) + ", " + hex(triangle.b) + ", " + hex(triangle.c) + "}";
}

inline std::string hex(const Ray& ray) {
    return "Ray{" + hex(ray.origin) + ", " + hex(ray.direction) + ", " + std::to_string(ray.skip) +
           "u}";
}

inline std::string describe(const ViewSet& set) {
    const GridSettings& s = set.settings;
    if (s.mode == ViewMode::full)
        return "fullViews(" + std::to_string(s.viewSize > 0 ? s.viewSize : s.height) + ", " +
               std::to_string(s.tile) + ")";
    return "singleView(" + std::to_string(s.width) + ", " + std::to_string(s.height) + ", " +
           std::to_string(s.tile) + ", " + hex(set.camera.verticalFov) + "f)";
}

} // namespace dirt::test
