#pragma once

#include "core/scene/camera.h"
#include "core/scene/transform.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace dirt {

/// The highest number of a frame.
inline constexpr int kMaxFrame = 999'999;

/// A value at times of its own, in seconds: held before the first key and after the last one,
/// interpolated in between.
template <typename Value>
struct Track {
    struct Key {
        double time;
        Value value;
    };
    std::vector<Key> keys; ///< times ascend strictly
};

/// How an object moves in the space around it: scale, then rotation, then translation. No track is
/// without keys.
struct TransformMotion {
    Track<glm::dvec3> scale, translation; ///< linear
    Track<Rotation> rotation;             ///< spherical linear, the shorter way
};

/// How the camera moves. What has no keys stays as it is.
struct CameraMotion {
    Track<glm::dvec3> eye, target, up; ///< linear
    Track<double> verticalFov;         ///< linear, degrees
};

/// A moving space, within another one or the world.
struct MovingSpace {
    static constexpr uint32_t kWorld = 0xffffffffu;

    uint32_t parent = kWorld; ///< into Animation::spaces, where it comes earlier
    glm::dmat4 toParent{1.0}; ///< what stands still between the motion and the parent
    TransformMotion motion;
};

/// A run of a Mesh's positions and normals that lies in a moving space.
struct MovingPart {
    uint32_t space = 0;     ///< into Animation::spaces
    glm::dvec3 origin{0.0}; ///< in that space; see core/scene/origin.h
    size_t firstPosition = 0, firstNormal = 0;
    std::vector<glm::vec3> positions; ///< in that space less the origin, rounded to float32 once
    std::vector<glm::vec3> normals;   ///< in that space, unit length
};

/// All that moves in a scene. Frame k stands at k / fps seconds.
struct Animation {
    double fps = 25.0;
    std::vector<MovingSpace> spaces;
    std::vector<MovingPart> parts;
    std::optional<CameraMotion> camera;

    bool empty() const { return parts.empty() && !camera; }
    double timeOf(int frame) const { return frame / fps; }
    /// The last frame before everything is held; 0 where nothing moves.
    int lastFrame() const;
    /// The moving space's matrix at \p time, seconds.
    glm::dmat4 toWorld(uint32_t space, double time) const;
    /// That of a part's positions, which its space's origin is taken off.
    glm::dmat4 toWorld(const MovingPart& part, double time) const;
    /// \p camera with what moves as it is at \p time, seconds.
    Camera cameraAt(Camera camera, double time) const;
};

} // namespace dirt
