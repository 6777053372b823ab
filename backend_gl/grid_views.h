#pragma once

#include "backend_gl/texel_buffer.h"
#include "core/grid/grid.h"

#include <cstdint>
#include <vector>

namespace dirt {

/// The views of a frame as all passes over tiles need them: uniform block 0, the guard-banded
/// borders as texture 0, the border slopes as texture 1; and the triangles that hold the eye.
class GridViews {
public:
    void set(const Grid& grid);
    void setAtEye(std::vector<uint32_t> ids);

    void bind() const;

    const std::vector<uint32_t>& atEye() const { return atEye_; }
    GLuint atEyeTexture() const { return atEyeIds_.texture(); }

private:
    GlBuffer parameters_;
    TexelBuffer borders_, slopes_, atEyeIds_;
    std::vector<uint32_t> atEye_;
};

} // namespace dirt
