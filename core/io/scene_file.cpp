#include "core/io/scene_file.h"

#include "core/io/key_frames.h"
#include "core/io/text_file.h"
#include "core/io/xml.h"
#include "core/scene/transform.h"
#include "shaders/shared/radiance.h"

#include <algorithm>
#include <cfloat>
#include <cstdio>
#include <iterator>
#include <set>
#include <string_view>

#include <glm/common.hpp>

namespace dirt {

namespace {

constexpr SceneAttribute kHonoured[] = {
    {"world", "background"},
    {"world", "fps"},
    {"world", "microfacet_model"},
    {"world", "materials"},
    {"world", "binary_loading"},
    {"world", "multithreaded_loading"},
    {"directory", "path"},
    {"tracing", "faces"},
    {"tracing", "block_size"},
    {"tracing", "buckets"},
    {"tracing", "indirect_bounces"},
    {"tracing", "accurate_visibility"},
    {"tracing", "dof"},
    {"tracing", "aperture_radius"},
    {"tracing", "focal_distance"},
    {"camera", "aperture"},
    {"user", "position"},
    {"user", "lookat"},
    {"user", "target"}, // what some of the demo's files say for lookat
    {"user", "up"},
    {"key", "time"},
    {"key", "frame"},
    {"key", "scale"},
    {"key", "rotation"},
    {"key", "translation"},
    {"key", "position"},
    {"key", "lookat"},
    {"key", "target"},
    {"key", "up"},
    {"key", "aperture"},
    {"light", "active"},
    {"light", "type"},
    {"light", "position"},
    {"light", "target"},
    {"light", "flux"},
    {"light", "color"},
    {"light", "aperture"},
    {"light", "penumbra"},
    {"light", "spotlight_exponent"},
    {"light", "conical"},
    {"light", "shadows"},
    {"light", "resolution"},
    {"light", "near_range"},
    {"light", "far_range"},
    {"light", "constant_bias"},
    {"light", "soft_shadow_size"},
    {"transformation", "scale"},
    {"transformation", "rotation"},
    {"transformation", "translation"},
    {"object", "file"},
    {"object", "double_sided"},
    {"object", "materials"},
    {"tonemapping", "key"},
    {"tonemapping", "white"},
};

class SceneFileReader {
public:
    SceneFileReader(const std::filesystem::path& file, LoadReport& report,
                    const MemoryBudget& budget)
        : xml_(file, budget), report_(report) {
        scene_.file = file;
    }

    SceneFile read() {
        const pugi::xml_node root = xml_.root();
        if (std::string_view(root.name()) != "world")
            xml_.fail(root, "the root element must be <world>");
        const XmlAttributes attributes = attributesOf(root);
        background(attributes, root);
        scene_.animation.fps = attributes.real("fps", 0.001, 1e5).value_or(scene_.animation.fps);
        microfacetModel(attributes, root);
        scene_.materials = materials(attributes, root);
        scene_.cache = attributes.boolean("binary_loading").value_or(scene_.cache);
        scene_.showParts = attributes.boolean("multithreaded_loading").value_or(scene_.showParts);
        for (const pugi::xml_node child : root.children()) worldChild(child);
        return std::move(scene_);
    }

private:
    void background(const XmlAttributes& attributes, pugi::xml_node node) {
        const auto radiance = attributes.colour("background");
        if (!radiance) return;
        scene_.background = glm::min(*radiance, kMostRadiance);
        if (scene_.background == *radiance) return;
        char text[64];
        std::snprintf(text, sizeof text, "background is above %g, and taken for it",
                      (double) kMostRadiance);
        report_.warn(WarningKind::unusableValue, scene_.file, xml_.line(node), text);
    }

    void microfacetModel(const XmlAttributes& attributes, pugi::xml_node root) {
        const auto name = attributes.text("microfacet_model");
        if (!name) return;
        constexpr std::string_view kNames[] = {"beckmann", "ggx", "cooktorrance", "phong"};
        const auto* const found = std::find(std::begin(kNames), std::end(kNames), *name);
        if (found == std::end(kNames))
            xml_.fail(root, "microfacet_model=" + inQuotes(*name) +
                                " is none of beckmann, ggx, cooktorrance, phong");
        scene_.microfacetModel = (MicrofacetModel) (found - std::begin(kNames));
    }

    std::optional<MaterialConvention> materials(const XmlAttributes& attributes,
                                                pugi::xml_node node) const {
        const auto name = attributes.text("materials");
        if (!name) return std::nullopt;
        const auto convention = parseMaterialConvention(*name);
        if (!convention)
            xml_.fail(node, "materials=" + inQuotes(*name) + " is neither demo nor wavefront");
        return convention;
    }

    void worldChild(pugi::xml_node node) {
        const std::string_view name = node.name();
        if (name == "directory")
            directory(node);
        else if (name == "tracing")
            tracing(once(node));
        else if (name == "camera")
            camera(once(node));
        else if (name == "user")
            user(once(node));
        else if (name == "light")
            light(node);
        else if (name == "tonemapping")
            toneMapping(once(node));
        else
            placed(node, Place());
    }

    /// Typed access to the node's attributes; those without effect are reported.
    XmlAttributes attributesOf(pugi::xml_node node) {
        const XmlAttributes attributes(xml_, node);
        const std::string_view element = node.name();
        attributes.ignoreOthers(
            [element](std::string_view name) {
                return std::any_of(std::begin(kHonoured), std::end(kHonoured),
                                   [&](const SceneAttribute& honoured) {
                                       return honoured.element == element &&
                                              honoured.attribute == name;
                                   });
            },
            report_);
        return attributes;
    }

    pugi::xml_node once(pugi::xml_node node) {
        if (!seen_.insert(node.name()).second) xml_.fail(node, "there may be one only");
        return node;
    }

    void directory(pugi::xml_node node) {
        const XmlAttributes attributes = attributesOf(node);
        scene_.directories.push_back(attributes.text("path").value_or(""));
        ignoreChildren(node);
    }

    void tracing(pugi::xml_node node) {
        const XmlAttributes attributes = attributesOf(node);
        SceneSettings& settings = scene_.settings;
        // The ranges of the program's options.
        settings.tile = attributes.integer("block_size", 1, 64);
        settings.bins = attributes.integer("buckets", 1, 256);
        if (const auto bounces = attributes.integer("indirect_bounces", 0, 1023))
            settings.bounces = *bounces + 1;
        if (const auto traced = attributes.boolean("accurate_visibility"))
            settings.visibility = *traced ? LightVisibility::traced : LightVisibility::shadowMap;
        if (attributes.boolean("dof").value_or(true)) {
            Camera& camera = scene_.camera;
            camera.apertureRadius =
                attributes.number("aperture_radius", 0.0, 1e30).value_or(camera.apertureRadius);
            camera.focalDistance =
                attributes.number("focal_distance", 1e-30, 1e30).value_or(camera.focalDistance);
        }
        if (const auto faces = attributes.text("faces")) {
            if (*faces != "cubemap" && *faces != "single")
                xml_.fail(node, "faces=" + inQuotes(*faces) + " is neither cubemap nor single");
            settings.view = *faces == "single" ? ViewMode::single : ViewMode::full;
        }
        ignoreChildren(node);
    }

    void camera(pugi::xml_node node) {
        const XmlAttributes attributes = attributesOf(node);
        float& fov = scene_.camera.verticalFov;
        fov = attributes.number("aperture", 0.001, 179.0).value_or(fov);
        if (const auto animation = keyFrames().animationIn(node))
            keyFrames().cameraMotion(animation, cameraMotion());
        ignoreChildren(node);
    }

    void user(pugi::xml_node node) {
        const XmlAttributes attributes = attributesOf(node);
        const auto eye = attributes.vector3("position");
        auto target = attributes.vector3("lookat");
        if (!target) target = attributes.vector3("target");
        const auto up = attributes.vector3("up");
        scene_.hasCamera = eye.has_value() || target.has_value();
        SceneFile::Points& points = scene_.points;
        points.eye = eye.value_or(points.eye);
        points.target = target;
        if (eye) scene_.camera.eye = *eye;
        scene_.camera.target =
            target ? glm::vec3(*target) : scene_.camera.eye + glm::vec3(0.0f, 0.0f, -1.0f);
        if (up) scene_.camera.up = *up;
        if (const auto animation = keyFrames().animationIn(node)) {
            keyFrames().userMotion(animation, cameraMotion());
            scene_.hasCamera = true;
        } else {
            points.userLine = xml_.line(node);
            if (target == points.eye) xml_.fail(node, "position and lookat are the same point");
        }
        if (scene_.camera.up == glm::vec3(0.0f)) xml_.fail(node, "up is zero");
        ignoreChildren(node);
    }

    KeyFrameReader keyFrames() const { return {xml_, scene_.animation.fps, report_}; }

    CameraMotion& cameraMotion() {
        if (!scene_.animation.camera) scene_.animation.camera.emplace();
        return *scene_.animation.camera;
    }

    void light(pugi::xml_node node) {
        const XmlAttributes attributes = attributesOf(node);
        ignoreChildren(node);
        if (!attributes.boolean("active").value_or(true)) return;
        const std::string type = attributes.text("type").value_or("spotlight");
        if (type != "spotlight") xml_.fail(node, "type=" + inQuotes(type) + " is not spotlight");
        if (scene_.light) xml_.fail(node, "there may be one active light only");

        Spotlight light;
        light.conical = attributes.boolean("conical").value_or(light.conical);
        light.shadows = attributes.boolean("shadows").value_or(light.shadows);
        light.flux = roundedFlux(attributes.wideReal("flux", 0.0).value_or(light.flux));
        light.color = attributes.colour("color").value_or(light.color);
        SceneFile::Points& points = scene_.points;
        points.lightLine = xml_.line(node);
        points.lightPosition = attributes.vector3("position").value_or(light.position);
        points.lightTarget = attributes.vector3("target").value_or(light.target);
        if (points.lightPosition == points.lightTarget)
            xml_.fail(node, "position and target are the same point");
        light.position = points.lightPosition;
        light.target = points.lightTarget;
        const double widest = light.conical ? 360.0 : 179.0;
        light.aperture = attributes.number("aperture", 0.001, widest).value_or(light.aperture);
        light.penumbra =
            attributes.number("penumbra", 0.0, light.aperture).value_or(light.aperture);
        light.exponent =
            attributes.number("spotlight_exponent", 0.0, FLT_MAX).value_or(light.exponent);
        shadowMap(node, attributes, light);
        scene_.light = light;
    }

    void shadowMap(pugi::xml_node node, const XmlAttributes& attributes, Spotlight& light) {
        light.resolution = attributes.integer("resolution", 1, 16384).value_or(light.resolution);
        light.nearRange = attributes.number("near_range", 0.0, FLT_MAX).value_or(light.nearRange);
        light.farRange = attributes.number("far_range", 0.0, FLT_MAX).value_or(light.farRange);
        if (attributes.text("far_range") && !(light.farRange > light.nearRange))
            xml_.fail(node, "far_range is not beyond near_range");
        light.constantBias =
            attributes.number("constant_bias", 0.0, 1.0).value_or(light.constantBias);
        light.softShadowSize =
            attributes.number("soft_shadow_size", 0.0, FLT_MAX).value_or(light.softShadowSize);
    }

    void toneMapping(pugi::xml_node node) {
        const XmlAttributes attributes = attributesOf(node);
        ToneMapping& tone = scene_.toneMapping;
        // 10^key must be a float32 number above 0.
        tone.key = attributes.number("key", -37.0, 38.0).value_or(tone.key);
        if (const auto white = attributes.colour("white")) {
            tone.white = std::max({white->x, white->y, white->z});
            if (!(tone.white > 0.0f)) xml_.fail(node, "white is black");
        }
        ignoreChildren(node);
    }

    /// Where an object stands: in a moving space or the world, and how in there.
    struct Place {
        uint32_t space = MovingSpace::kWorld;
        glm::dmat4 toSpace{1.0};
    };

    /// What may stand in a <transformation>, or in <world>.
    void placed(pugi::xml_node node, const Place& parent) {
        const std::string_view name = node.name();
        if (name == "transformation")
            transformation(node, parent);
        else if (name == "object")
            object(node, parent);
        else
            ignoreNode(node, report_);
    }

    void transformation(pugi::xml_node node, const Place& parent) {
        const XmlAttributes attributes = attributesOf(node);
        const auto scale = attributes.vector3("scale").value_or(glm::dvec3(1.0));
        const auto translation = attributes.vector3("translation").value_or(glm::dvec3(0.0));
        const Rotation rotation = rotationOf(xml_, node, attributes).value_or(Rotation());
        Place place = parent;
        const pugi::xml_node animation = keyFrames().animationIn(node);
        if (animation) {
            std::vector<MovingSpace>& spaces = scene_.animation.spaces;
            spaces.push_back(
                {parent.space, parent.toSpace,
                 keyFrames().transformMotion(animation, scale, rotation, translation)});
            place = {(uint32_t) spaces.size() - 1, glm::dmat4(1.0)};
        } else {
            place.toSpace *= placement(scale, rotationMatrix(rotation), translation);
        }
        for (const pugi::xml_node child : node.children())
            if (child != animation) placed(child, place);
    }

    void object(pugi::xml_node node, const Place& place) {
        const XmlAttributes attributes = attributesOf(node);
        const auto file = attributes.text("file");
        if (!file || trimmed(*file).empty()) xml_.fail(node, "file is missing");
        scene_.objects.push_back({*file, xml_.line(node), place.toSpace, place.space,
                                  attributes.boolean("double_sided").value_or(true),
                                  materials(attributes, node)});
        ignoreChildren(node);
    }

    /// But for the animation, where the element has one.
    void ignoreChildren(pugi::xml_node node) {
        const std::string_view name = node.name();
        const bool animated = name == "user" || name == "camera";
        for (const pugi::xml_node child : node.children())
            if (!animated || std::string_view(child.name()) != "animation")
                ignoreNode(child, report_);
    }

    XmlFile xml_;
    LoadReport& report_;
    SceneFile scene_;
    std::set<std::string> seen_; ///< elements that may be there once
};

} // namespace

std::span<const SceneAttribute> honouredSceneAttributes() {
    return kHonoured;
}

SceneFile readSceneFile(const std::filesystem::path& file, LoadReport& report,
                        const MemoryBudget& budget) {
    return SceneFileReader(file, report, budget).read();
}

} // namespace dirt
