#pragma once

#include "app/cli/input.h"
#include "core/trace/ray.h"

#include <optional>
#include <string>

namespace dirt {

/// A ray in the grid frame, of which the nearest hit is asked, or (with maxT) whether anything is
/// hit before.
struct AskedRay {
    Ray ray;
    std::optional<float> maxT;
};

/// Prints a ray's way through the grid of \p backend, what the backend says of it, and the truth.
/// Holes are not looked at, as in `dirt verify`. 1 where one of the three differs from the others.
/// \p image: a PNG file to draw it into, where the backend has a grid.
int explainRay(const Input& input, Backend& backend, const AskedRay& asked,
               const std::optional<std::string>& image, bool json);

} // namespace dirt
