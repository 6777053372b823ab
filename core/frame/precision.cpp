#include "core/frame/precision.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstdio>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace dirt {

namespace {

/// Coordinates coarser than this part of the scene show: a step of a pixel in a picture of 4,096
/// pixels across it, seen sixteen times enlarged.
constexpr double kCoarse = 0x1p-16;

double spacingAt(double coordinate) {
    const float x = (float) std::min(coordinate, (double) FLT_MAX / 2);
    return (double) std::nextafter(x, FLT_MAX) - (double) x;
}

bool hasArea(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) {
    return glm::cross(b - a, c - a) != glm::dvec3(0.0);
}

double largest(glm::dvec3 v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

std::string line(const char* format, double first, double second) {
    char text[200];
    std::snprintf(text, sizeof text, format, first, second);
    return text;
}

} // namespace

PrecisionReach precisionReach(const Mesh& mesh, const FrameGeometry& geometry) {
    PrecisionReach reach;
    glm::dvec3 low(DBL_MAX), high(-DBL_MAX);
    double farthest = 0.0;
    for (size_t i = 0; i < mesh.triangles.size(); ++i) {
        const Corners& corners = mesh.triangles[i];
        glm::dvec3 p[3];
        for (int k = 0; k < 3; ++k) {
            p[k] = glm::dvec3(mesh.positions[corners[k]]);
            low = glm::min(low, p[k]);
            high = glm::max(high, p[k]);
        }
        const Triangle& t = geometry.triangles[i];
        farthest = std::max({farthest, largest(t.a), largest(t.b), largest(t.c)});
        if (hasArea(t.a, t.b, t.c)) continue;
        ++reach.withoutArea;
        if (hasArea(p[0], p[1], p[2])) ++reach.flattened;
    }
    if (mesh.triangles.empty()) return reach;
    reach.diagonal = glm::length(high - low);
    reach.worldSpacing = spacingAt(std::max(largest(low), largest(high)));
    reach.frameSpacing = spacingAt(farthest) / geometry.frame.scale;
    return reach;
}

std::vector<std::string> precisionWarnings(const PrecisionReach& reach) {
    std::vector<std::string> warnings;
    if (reach.worldSpacing > kCoarse * reach.diagonal)
        warnings.push_back(line("coordinates are so large that float32 resolves %g of them, in a "
                                "scene of %g: move it to the origin",
                                reach.worldSpacing, reach.diagonal));
    else if (reach.frameSpacing > kCoarse * reach.diagonal)
        warnings.push_back(line("the eye is so far away that float32 resolves %g of a scene of %g",
                                reach.frameSpacing, reach.diagonal));
    if (reach.flattened > 0)
        warnings.push_back(std::to_string(reach.flattened) +
                           " triangles lose their area in the rounding of the grid frame");
    return warnings;
}

} // namespace dirt
