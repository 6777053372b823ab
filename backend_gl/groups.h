#pragma once

#include <cstddef>

#include <epoxy/gl.h>

namespace dirt {

/// Groups of 64 invocations, as many as all shaders that run over a list have, for \p count.
inline GLuint groupsOf(size_t count) {
    constexpr size_t kGroup = 64;
    return (GLuint) ((count + kGroup - 1) / kGroup);
}

} // namespace dirt
