#pragma once

#include <vector>

#include <glm/vec3.hpp>

namespace dirt {

/// Row-major pixels, the first row on top; linear Rec.709 radiance.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<glm::vec3> pixels;
};

} // namespace dirt
