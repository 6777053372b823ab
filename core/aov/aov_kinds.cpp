#include "core/aov/aov_kinds.h"

#include "core/base/error.h"
#include "core/io/load_report.h"
#include "core/path/world_position.h"

#include <algorithm>
#include <iterator>

#include <glm/geometric.hpp>

namespace dirt {

namespace {

using Of = AovKind::Of;

/// As far as Cycles has it where there is nothing; finite, so that filters can go over it.
constexpr double kFarAway = 1e10;

glm::dvec3 albedo(const AovFrame&, const SurfacePoint& point) {
    return point.diffuse;
}
glm::dvec3 emission(const AovFrame&, const SurfacePoint& point) {
    return point.emission;
}
glm::dvec3 normal(const AovFrame& frame, const SurfacePoint& point) {
    return onWorldAxes(frame.grid, point.shadingNormal);
}
glm::dvec3 geometricNormal(const AovFrame& frame, const SurfacePoint& point) {
    return onWorldAxes(frame.grid, point.geometricNormal);
}
glm::dvec3 roughness(const AovFrame&, const SurfacePoint& point) {
    return glm::dvec3(point.roughness);
}
glm::dvec3 depth(const AovFrame& frame, const SurfacePoint& point) {
    return glm::dvec3(glm::dot(glm::dvec3(point.position), frame.forward) / frame.grid.scale);
}
glm::dvec3 position(const AovFrame& frame, const SurfacePoint& point) {
    return worldPosition(frame.scene, frame.grid, point.position);
}

constexpr AovKind kKinds[] = {
    {"albedo", "RGB", Of::allSamples, albedo, 0.0},
    {"emission", "RGB", Of::allSamples, emission, 0.0},
    {"normal", "XYZ", Of::allSamples, normal, 0.0},
    {"geometricNormal", "XYZ", Of::allSamples, geometricNormal, 0.0},
    {"roughness", "X", Of::hits, roughness, 0.0},
    {"depth", "Z", Of::hits, depth, kFarAway},
    {"position", "XYZ", Of::hits, position, 0.0},
    {"id", "X", Of::firstSample, nullptr, 0.0},
    {"variance", "RGB", Of::radiance, nullptr, 0.0},
};

} // namespace

std::span<const AovKind> aovKinds() {
    return kKinds;
}

std::vector<const AovKind*> aovKindsOf(const std::vector<std::string>& names) {
    std::vector<const AovKind*> kinds;
    for (const std::string& name : names) {
        const auto kind = std::find_if(std::begin(kKinds), std::end(kKinds),
                                       [&](const AovKind& known) { return name == known.name; });
        if (kind == std::end(kKinds))
            throw InputError("--aov " + printable(name) + ": there are " + aovNames());
        if (std::find(kinds.begin(), kinds.end(), kind) != kinds.end())
            throw InputError("--aov: " + name + " is there twice");
        kinds.push_back(kind);
    }
    return kinds;
}

std::string aovNames() {
    std::string names;
    for (const AovKind& kind : kKinds) names += (names.empty() ? "" : ",") + std::string(kind.name);
    return names;
}

} // namespace dirt
