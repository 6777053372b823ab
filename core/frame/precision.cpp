#include "core/frame/precision.h"

#include "core/frame/transform_mesh.h"

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

/// An eye that is off by more of the distance to what it looks at moves the picture: by a pixel of
/// 4,096 across.
constexpr double kCoarseEye = 0x1p-12;

constexpr size_t kSurveyedAtOnce = 8192;

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

/// What some of the triangles say.
struct Survey {
    Bounds box;
    double farthest = 0.0; ///< largest |coordinate| in the grid frame
    uint64_t withoutArea = 0, flattened = 0;

    void add(const Mesh& mesh, size_t triangle, const Triangle& t) {
        glm::dvec3 p[3];
        for (int k = 0; k < 3; ++k) {
            p[k] = glm::dvec3(mesh.positions[mesh.triangles[triangle][k]]);
            box.include(p[k]);
        }
        farthest = std::max({farthest, largest(t.a), largest(t.b), largest(t.c)});
        if (hasArea(t.a, t.b, t.c)) return;
        ++withoutArea;
        if (hasArea(p[0], p[1], p[2])) ++flattened;
    }
    void add(const Survey& other) {
        box.low = glm::min(box.low, other.box.low);
        box.high = glm::max(box.high, other.box.high);
        farthest = std::max(farthest, other.farthest);
        withoutArea += other.withoutArea;
        flattened += other.flattened;
    }
};

std::string line(const char* format, double first, double second) {
    char text[200];
    std::snprintf(text, sizeof text, format, first, second);
    return text;
}

} // namespace

PrecisionReach precisionReach(const Mesh& mesh, const Camera& camera, ViewMode mode,
                              Executor& executor) {
    FrameGeometry geometry;
    transformMesh(mesh, camera, mode, executor, geometry);
    const size_t count = mesh.triangles.size();
    std::vector<Survey> pieces((count + kSurveyedAtOnce - 1) / kSurveyedAtOnce);
    executor.forRange(count, kSurveyedAtOnce, [&](size_t begin, size_t end) {
        Survey survey;
        for (size_t i = begin; i < end; ++i) survey.add(mesh, i, geometry.triangles[i]);
        pieces[begin / kSurveyedAtOnce] = survey;
    });
    Survey all;
    for (const Survey& piece : pieces) all.add(piece);
    PrecisionReach reach;
    reach.triangles = count;
    reach.withoutArea = all.withoutArea;
    reach.flattened = all.flattened;
    if (count == 0) return reach;
    reach.box = all.box;
    reach.diagonal = glm::length(all.box.high - all.box.low);
    reach.worldSpacing = spacingAt(std::max(largest(all.box.low), largest(all.box.high)));
    reach.frameSpacing = spacingAt(all.farthest) / geometry.frame.scale;
    reach.eyeSpacing = spacingAt(largest(camera.eye));
    reach.distance = glm::length(glm::dvec3(camera.target) - glm::dvec3(camera.eye));
    return reach;
}

std::vector<PrecisionWarning> precisionWarnings(const PrecisionReach& reach) {
    using Cause = PrecisionWarning::Cause;
    std::vector<PrecisionWarning> warnings;
    if (reach.withoutArea > reach.flattened && reach.withoutArea == reach.triangles) {
        // Nothing can be said of the size of what is a point or a line.
        warnings.push_back({Cause::withoutArea, "no triangle has an area: nothing is seen"});
        return warnings;
    }
    if (reach.worldSpacing > kCoarse * reach.diagonal)
        warnings.push_back({Cause::largeCoordinates,
                            line("coordinates are so large that float32 resolves %g of them, in a "
                                 "scene of %g",
                                 reach.worldSpacing, reach.diagonal)});
    else if (reach.frameSpacing > kCoarse * reach.diagonal)
        warnings.push_back({Cause::distantEye,
                            line("the eye is so far away that float32 resolves %g of a scene of %g",
                                 reach.frameSpacing, reach.diagonal)});
    else if (reach.eyeSpacing > kCoarseEye * reach.distance)
        warnings.push_back(
            {Cause::farFromZero,
             line("the eye is so far from 0 that float32 resolves %g there, and what "
                  "it looks at is %g away",
                  reach.eyeSpacing, reach.distance)});
    if (reach.flattened > 0)
        warnings.push_back(
            {Cause::flattened, std::to_string(reach.flattened) + " of " +
                                   std::to_string(reach.triangles) +
                                   " triangles lose their area where the eye is subtracted"});
    return warnings;
}

} // namespace dirt
