#pragma once

#include "core/io/load_report.h"
#include "core/io/xml.h"
#include "core/scene/animation.h"

#include <optional>

namespace dirt {

/// The attribute `rotation`: an angle in degrees and an axis. Throws InputError where the axis is
/// zero but the angle is not.
std::optional<Rotation> rotationOf(const XmlFile& xml, pugi::xml_node node,
                                   const XmlAttributes& attributes);

/// Reads `<animation>` elements. Each animates the attributes of the element that it stands in: its
/// `<key>`s say what they are at a time. An attribute that no key gives stays what the element
/// says. Throws InputError at a key's line where it has not exactly one of `time` and `frame`, its
/// time is not after that of the key before, or a value is malformed or out of range.
class KeyFrameReader {
public:
    KeyFrameReader(const XmlFile& xml, double fps, LoadReport& report)
        : xml_(xml), fps_(fps), report_(report) {}

    /// The `<animation>` in \p parent; none where there is none. There may be one only.
    pugi::xml_node animationIn(pugi::xml_node parent) const;

    /// Of a `<transformation>`: scale, rotation, translation.
    TransformMotion transformMotion(pugi::xml_node animation, const glm::dvec3& scale,
                                    const Rotation& rotation, const glm::dvec3& translation) const;
    /// Of the `<user>`: position, lookat (or target), up.
    void userMotion(pugi::xml_node animation, CameraMotion& motion) const;
    /// Of the `<camera>`: aperture.
    void cameraMotion(pugi::xml_node animation, CameraMotion& motion) const;

private:
    template <typename Visit>
    void forEachKey(pugi::xml_node animation, std::initializer_list<std::string_view> known,
                    Visit&& visit) const;
    double timeOf(pugi::xml_node key, const XmlAttributes& attributes) const;

    const XmlFile& xml_;
    double fps_;
    LoadReport& report_;
};

} // namespace dirt
