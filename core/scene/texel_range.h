#pragma once

#include <algorithm>
#include <span>

namespace dirt {

/// The least and the largest of a texture's numbers; 0 and 1 of bytes, whatever they are.
struct TexelRange {
    float least = 0.0f, largest = 1.0f;

    TexelRange() = default;
    /// Of finite numbers, one at least.
    explicit TexelRange(std::span<const float> texels) {
        const auto [low, high] = std::minmax_element(texels.begin(), texels.end());
        least = *low;
        largest = *high;
    }
};

} // namespace dirt
