#include "core/io/key_frames.h"

#include <algorithm>
#include <initializer_list>
#include <string_view>

#include <glm/vec4.hpp>

namespace dirt {

namespace {

/// Ten million seconds, as many frames as any rate gives, are half a year.
constexpr double kLatest = 1e7;

template <typename Value>
void append(Track<Value>& track, double time, const std::optional<Value>& value) {
    if (value) track.keys.push_back({time, *value});
}

template <typename Value>
void holdWithoutKeys(Track<Value>& track, const Value& value) {
    if (track.keys.empty()) track.keys.push_back({0.0, value});
}

} // namespace

std::optional<Rotation> rotationOf(const XmlFile& xml, pugi::xml_node node,
                                   const XmlAttributes& attributes) {
    const auto rotation = attributes.vector4("rotation");
    if (!rotation) return std::nullopt;
    const glm::dvec3 axis(rotation->y, rotation->z, rotation->w);
    if (axis != glm::dvec3(0.0)) return Rotation{rotation->x, axis};
    if (rotation->x != 0.0) xml.fail(node, "the rotation's axis is zero");
    return Rotation{};
}

pugi::xml_node KeyFrameReader::animationIn(pugi::xml_node parent) const {
    const pugi::xml_node animation = parent.child("animation");
    const pugi::xml_node second = animation.next_sibling("animation");
    if (second) xml_.fail(second, "there may be one only in <" + std::string(parent.name()) + ">");
    return animation;
}

/// Calls \p visit(key, attributes, time) for each <key> in turn.
template <typename Visit>
void KeyFrameReader::forEachKey(pugi::xml_node animation,
                                std::initializer_list<std::string_view> known,
                                Visit&& visit) const {
    XmlAttributes(xml_, animation).ignoreOthers([](std::string_view) { return false; }, report_);
    const auto isKnown = [&](std::string_view name) {
        return name == "time" || name == "frame" ||
               std::find(known.begin(), known.end(), name) != known.end();
    };
    std::optional<double> before;
    for (const pugi::xml_node key : animation.children()) {
        if (std::string_view(key.name()) != "key") {
            ignoreNode(key, report_);
            continue;
        }
        const XmlAttributes attributes(xml_, key);
        attributes.ignoreOthers(isKnown, report_);
        const double time = timeOf(key, attributes);
        if (before && !(time > *before)) xml_.fail(key, "is not after the key before it");
        before = time;
        visit(key, attributes, time);
        for (const pugi::xml_node child : key.children()) ignoreNode(child, report_);
    }
    if (!before) xml_.fail(animation, "holds no <key>");
}

double KeyFrameReader::timeOf(pugi::xml_node key, const XmlAttributes& attributes) const {
    const auto seconds = attributes.real("time", 0.0, kLatest);
    const auto frame = attributes.real("frame", 0.0, kMaxFrame);
    if (seconds.has_value() == frame.has_value())
        xml_.fail(key, seconds ? "has both a time and a frame" : "has neither a time nor a frame");
    return seconds ? *seconds : *frame / fps_;
}

TransformMotion KeyFrameReader::transformMotion(pugi::xml_node animation, const glm::dvec3& scale,
                                                const Rotation& rotation,
                                                const glm::dvec3& translation) const {
    TransformMotion motion;
    forEachKey(animation, {"scale", "rotation", "translation"},
               [&](pugi::xml_node key, const XmlAttributes& attributes, double time) {
                   append(motion.scale, time, attributes.vector3("scale"));
                   append(motion.rotation, time, rotationOf(xml_, key, attributes));
                   append(motion.translation, time, attributes.vector3("translation"));
               });
    holdWithoutKeys(motion.scale, scale);
    holdWithoutKeys(motion.rotation, rotation);
    holdWithoutKeys(motion.translation, translation);
    return motion;
}

void KeyFrameReader::userMotion(pugi::xml_node animation, CameraMotion& motion) const {
    forEachKey(animation, {"position", "lookat", "target", "up"},
               [&](pugi::xml_node, const XmlAttributes& attributes, double time) {
                   append(motion.eye, time, attributes.vector3("position"));
                   const auto lookat = attributes.vector3("lookat");
                   append(motion.target, time, lookat ? lookat : attributes.vector3("target"));
                   append(motion.up, time, attributes.vector3("up"));
               });
}

void KeyFrameReader::cameraMotion(pugi::xml_node animation, CameraMotion& motion) const {
    forEachKey(animation, {"aperture"},
               [&](pugi::xml_node, const XmlAttributes& attributes, double time) {
                   append(motion.verticalFov, time, attributes.real("aperture", 0.001, 179.0));
               });
}

} // namespace dirt
