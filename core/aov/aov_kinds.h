#pragma once

#include "core/grid/geometry.h"
#include "core/scene/scene.h"
#include "shaders/shared/layouts.h"

#include <span>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

namespace dirt {

/// What stands between a surface point and the coordinates that a layer has.
struct AovFrame {
    const Scene& scene;
    GridFrame grid;
    glm::dvec3 forward; ///< the camera's axis, on the grid frame's axes; of unit length
};

/// A layer that a render can have beside its image.
struct AovKind {
    /// What a pixel's value is made of.
    enum class Of {
        allSamples,  ///< mean of value() over the samples; those whose ray misses count as 0
        hits,        ///< mean over those that hit something; nothing() where none does
        firstSample, ///< the primitive id of the first sample
        radiance     ///< variance of the samples' radiance
    };

    const char* name;
    const char* letters; ///< of its channels: RGB, XYZ, or one letter
    Of of;
    /// Of the first hit of a sample's ray, in the order of the letters; null where nothing is.
    glm::dvec3 (*value)(const AovFrame&, const SurfacePoint&);
    double nothing; ///< where no sample hits anything; of all its channels

    size_t channels() const { return std::char_traits<char>::length(letters); }
};

/// All there are, in the order in which they are documented.
std::span<const AovKind> aovKinds();

/// Those of \p names. Throws InputError, which names those there are, where one is none of them or
/// is there twice.
std::vector<const AovKind*> aovKindsOf(const std::vector<std::string>& names);

/// "albedo,normal,…".
std::string aovNames();

} // namespace dirt
