#include "core/scene/animation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

namespace dirt {

namespace {

/// Two neighbouring keys and how far \p time is from the one to the other, in [0, 1). Exactly 0 at
/// a key and where a value is held.
template <typename Value>
struct Segment {
    const Value &first, &second;
    double weight = 0.0;

    Segment(const Track<Value>& track, double time) : Segment(track, indexAt(track, time), time) {}

private:
    static size_t indexAt(const Track<Value>& track, double time) {
        const auto after = std::upper_bound(track.keys.begin(), track.keys.end(), time,
                                            [](double t, const auto& key) { return t < key.time; });
        return after == track.keys.begin() ? 0 : (size_t) (after - track.keys.begin()) - 1;
    }
    Segment(const Track<Value>& track, size_t i, double time)
        : first(track.keys[i].value),
          second(track.keys[std::min(i + 1, track.keys.size() - 1)].value) {
        const double begin = track.keys[i].time;
        if (time > begin && i + 1 < track.keys.size())
            weight = (time - begin) / (track.keys[i + 1].time - begin);
    }
};

template <typename Value>
Value linearAt(const Track<Value>& track, double time) {
    const Segment<Value> segment(track, time);
    if (segment.weight == 0.0) return segment.first;
    return segment.first * (1.0 - segment.weight) + segment.second * segment.weight;
}

glm::dquat quaternion(const Rotation& rotation) {
    const double half = rotation.degrees * (std::numbers::pi / 360.0);
    return {std::cos(half), glm::normalize(rotation.axis) * std::sin(half)};
}

glm::dmat3 rotationAt(const Track<Rotation>& track, double time) {
    const Segment<Rotation> segment(track, time);
    if (segment.weight == 0.0) return rotationMatrix(segment.first);
    return glm::mat3_cast(
        glm::slerp(quaternion(segment.first), quaternion(segment.second), segment.weight));
}

template <typename Value>
double lastTime(const Track<Value>& track) {
    return track.keys.empty() ? 0.0 : track.keys.back().time;
}

} // namespace

int Animation::lastFrame() const {
    double last = 0.0;
    const auto include = [&last](double time) { last = std::max(last, time); };
    for (const MovingSpace& space : spaces) {
        include(lastTime(space.motion.scale));
        include(lastTime(space.motion.rotation));
        include(lastTime(space.motion.translation));
    }
    if (camera) {
        include(lastTime(camera->eye));
        include(lastTime(camera->target));
        include(lastTime(camera->up));
        include(lastTime(camera->verticalFov));
    }
    return (int) std::min(std::ceil(last * fps), (double) kMaxFrame);
}

glm::dmat4 Animation::toWorld(uint32_t space, double time) const {
    glm::dmat4 matrix(1.0);
    for (; space != MovingSpace::kWorld; space = spaces[space].parent) {
        const TransformMotion& motion = spaces[space].motion;
        const glm::dmat4 moved =
            placement(linearAt(motion.scale, time), rotationAt(motion.rotation, time),
                      linearAt(motion.translation, time));
        matrix = spaces[space].toParent * moved * matrix;
    }
    return matrix;
}

glm::dmat4 Animation::toWorld(const MovingPart& part, double time) const {
    glm::dmat4 matrix = toWorld(part.space, time);
    if (part.origin != glm::dvec3(0.0)) matrix[3] = matrix * glm::dvec4(part.origin, 1.0);
    return matrix;
}

Camera Animation::cameraAt(Camera result, double time) const {
    if (!camera) return result;
    if (!camera->eye.keys.empty()) result.eye = glm::vec3(linearAt(camera->eye, time));
    if (!camera->target.keys.empty()) result.target = glm::vec3(linearAt(camera->target, time));
    if (!camera->up.keys.empty()) result.up = glm::vec3(linearAt(camera->up, time));
    if (!camera->verticalFov.keys.empty())
        result.verticalFov = (float) linearAt(camera->verticalFov, time);
    return result;
}

} // namespace dirt
