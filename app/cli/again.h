#pragma once

#include "app/cli/input.h"

#include <string>

namespace dirt {

// Parts of the command lines that show again what a command has shown: whatever shapes it, said or
// not, to be pasted into a shell. Options come with a blank before each.

/// \p text as a shell takes it for one word.
std::string shellWord(const std::string& text);

/// "dirt COMMAND SCENE", after what the environment changes ("DIRT_SHADERS=FOLDER ").
std::string commandStart(const std::string& command, const std::string& scene);

/// What makes the same structure of the same scene with the backends of \p options.
std::string structureOptions(const Input& input, const CommonOptions& options);

/// What makes the same paths through it, for commands that shade.
std::string pathOptions(const Input& input, const CommonOptions& options);

/// A point of a scene with \p origin as --eye and --target have it: X,Y,Z in the coordinates of its
/// files.
std::string pointOption(const glm::dvec3& origin, glm::vec3 point);

/// " --eye … --target … --up … --fov …", which give the camera again.
std::string cameraOptions(const glm::dvec3& origin, const Camera& camera);

} // namespace dirt
