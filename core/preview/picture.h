#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

namespace dirt {

using Colour = glm::u8vec3; ///< R, G, B, as a screen shows them

/// Rows of 8-bit R, G, B, the first on top.
struct Picture {
    int width = 0, height = 0;
    std::vector<uint8_t> rgb;

    Picture() = default;
    /// Black.
    Picture(int width, int height)
        : width(width), height(height), rgb(3 * (size_t) width * (size_t) height, 0) {}

    bool holds(int x, int y) const { return x >= 0 && y >= 0 && x < width && y < height; }
    /// Of a pixel's first byte.
    size_t place(int x, int y) const { return 3 * ((size_t) y * (size_t) width + (size_t) x); }
    Colour at(int x, int y) const {
        const size_t i = place(x, y);
        return {rgb[i], rgb[i + 1], rgb[i + 2]};
    }
    void set(int x, int y, Colour colour) {
        const size_t i = place(x, y);
        for (int c = 0; c < 3; ++c) rgb[i + (size_t) c] = colour[c];
    }
};

} // namespace dirt
