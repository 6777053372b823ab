#pragma once

#include "app/cli/command.h"
#include "core/frame/settings.h"
#include "core/io/material_convention.h"
#include "core/scene/scene.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

namespace dirt {

/// What finds the hits.
enum class BackendKind { cpu, gl, embree };

/// As --backend has it.
const char* nameOf(BackendKind kind);

/// Image size in pixels.
struct ImageSize {
    int width = 0, height = 0;
};

// The most that options take. The pyramid over kMaxTiles = 2^13 tiles has the levels 0 to 13.
inline constexpr int kLargestTile = 64, kMostBins = 256, kHighestLevel = 13, kMostBounces = 1024;

/// The options that every command with a scene has. What is not given stays empty, and the scene
/// file's value, or else the default, holds.
struct CommonOptions {
    std::string scene; ///< a .scene file or a bare .obj, .gltf or .glb
    BackendKind backend = BackendKind::cpu;
    std::vector<BackendKind> backends; ///< of a command that uses several; else empty
    int device = -1;                   ///< of OpenGL; -1: the first that works

    std::optional<ViewMode> view;
    std::optional<ImageSize> size;
    std::optional<int> viewSize;
    std::optional<int> tile;
    std::optional<int> bins;
    std::optional<int> maxMip;
    std::optional<Traversal> traversal;
    std::optional<Precision> precision;
    std::optional<Primary> primary;
    std::optional<Fetch> fetch;
    std::optional<LightVisibility> visibility;
    std::optional<Shading> shading;
    std::optional<int> samples;
    std::optional<int> bounces;
    std::optional<uint32_t> seed;
    std::optional<RayType> rayType;

    std::optional<std::string> camera;     ///< of a model file: a number or a name
    std::optional<glm::dvec3> eye, target; ///< in the coordinates of the scene's files
    std::optional<glm::vec3> up;
    std::optional<float> verticalFov; ///< degrees

    std::optional<int> frame; ///< of an animated scene

    /// What all MTL files are taken for.
    std::optional<MaterialConvention> materials;

    std::optional<uint64_t> memory; ///< bytes that a scene may take

    unsigned threads = 0; ///< 0: all cores
    bool quiet = false;   ///< nothing on standard error but errors
    bool noCache = false; ///< neither read nor leave caches of models
    bool strict = false;  ///< what a scene lacks is an error, not a warning

    bool sweeps = false;            ///< the command makes other choices than these in turn
    std::vector<std::string> given; ///< options that not every backend honours
};

/// Adds SCENE and the common options to \p command. Values out of range end the parsing with an
/// InputError. \p options must outlive the parsing.
void addCommonOptions(Command command, CommonOptions& options);

/// The same without SCENE, for commands that take several.
void addSettingsOptions(Command command, CommonOptions& options);

/// \p settings (the scene file's over the defaults) with the options that were given on top.
/// Throws InputError where the image, or the structure without its lists, would need more memory
/// than sceneMemory.
RenderSettings mergeSettings(RenderSettings settings, const CommonOptions& options);

/// Throws InputError where --eye and --target are the same point, or --up is zero.
void checkCameraOptions(const CommonOptions& options);

/// The camera of \p scene with --eye, --target, --up and --fov on top. Throws InputError where eye
/// and target coincide or the view is along the up direction.
Camera mergeCamera(const Scene& scene, const CommonOptions& options);

} // namespace dirt
