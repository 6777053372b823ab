#pragma once

#include <span>

namespace dirt {

/// A file of the folder shaders/, as it was when the program was built.
struct EmbeddedShader {
    const char* file; ///< relative to shaders/
    const char* text;
};

extern const std::span<const EmbeddedShader> kEmbeddedShaders;

} // namespace dirt
