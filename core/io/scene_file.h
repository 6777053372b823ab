#pragma once

#include "core/frame/settings.h"
#include "core/io/load_report.h"
#include "core/io/material_convention.h"
#include "core/io/memory_budget.h"
#include "core/scene/scene.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/mat4x4.hpp>

namespace dirt {

/// The render settings that a .scene file gives (element `<tracing>`).
struct SceneSettings {
    std::optional<int> tile;                   ///< block_size, pixels
    std::optional<int> bins;                   ///< buckets
    std::optional<int> bounces;                ///< indirect_bounces + 1
    std::optional<ViewMode> view;              ///< faces: cubemap is full, single is single
    std::optional<LightVisibility> visibility; ///< accurate_visibility: traced
};

/// A .scene file: XML in the format of the 2017 DIRT demo. Geometry is named, not loaded.
struct SceneFile {
    /// One model file and its place.
    struct Object {
        std::string file; ///< as written
        size_t line = 0;
        glm::dmat4 toSpace{1.0};              ///< of a moving space, or of the world
        uint32_t space = MovingSpace::kWorld; ///< into animation.spaces
        bool doubleSided = true;              ///< else as Material::doubleSided, and glTF, have it
        std::optional<MaterialConvention> materials; ///< of its MTL files
    };

    /// The points of `<user>` and `<light>` in double, and where they stand in the file. The camera
    /// and the light have them rounded.
    struct Points {
        glm::dvec3 eye{0.0};
        std::optional<glm::dvec3> target; ///< none: one unit along -z from the eye
        size_t userLine = 0;              ///< 0: the two may coincide, as keys move them
        glm::dvec3 lightPosition{0.0}, lightTarget{0.0};
        size_t lightLine = 0;
    };

    std::filesystem::path file;
    std::vector<std::string> directories; ///< where objects are looked for, as written
    std::vector<Object> objects;
    Camera camera;
    bool hasCamera = false; ///< whether the file says where the camera stands
    std::optional<Spotlight> light;
    Points points;
    glm::vec3 background{0.0f};
    MicrofacetModel microfacetModel = MicrofacetModel::beckmann;
    std::optional<MaterialConvention> materials; ///< of objects that do not say
    ToneMapping toneMapping;
    Animation animation; ///< without parts
    bool cache = true;   ///< binary_loading: whether models may be read through caches
    /// multithreaded_loading: whether what has been read may be shown before all has; threads read
    /// in any case.
    bool showParts = true;
    SceneSettings settings;
};

/// An attribute of one of the format's elements.
struct SceneAttribute {
    std::string_view element, attribute;
};

/// The attributes that readSceneFile honours. (`name` may stand anywhere, as a label.)
std::span<const SceneAttribute> honouredSceneAttributes();

/// Reads a .scene file. Elements and attributes without effect are reported as ignored. Throws
/// InputError with the element's line where the file is not well-formed XML, a value is malformed
/// or out of range, or an element that may be there once is there twice.
SceneFile readSceneFile(const std::filesystem::path& file, LoadReport& report,
                        const MemoryBudget& budget = {});

} // namespace dirt
