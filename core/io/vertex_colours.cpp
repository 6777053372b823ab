#include "core/io/vertex_colours.h"

#include "core/io/number.h"
#include "core/scene/srgb.h"

#include <algorithm>
#include <cmath>

namespace dirt {

namespace {

constexpr glm::vec3 kNoColour(-1.0f);

} // namespace

bool VertexColours::set(size_t vertex, const glm::dvec3& colour) {
    const double least = std::min({colour.x, colour.y, colour.z});
    if (!fitsFloat(colour) || !(least >= 0.0)) return false;
    for (int i = 0; i < 3; ++i) {
        whole_ = whole_ && colour[i] == std::floor(colour[i]);
        largest_ = std::max(largest_, colour[i]);
    }
    colours_.resize(vertex, kNoColour);
    colours_.emplace_back(colour);
    return true;
}

std::vector<glm::vec3> VertexColours::decoded(size_t vertices) const {
    if (colours_.empty()) return {};
    const double white = areOf255() ? 255.0 : 1.0;
    std::vector<glm::vec3> linear(vertices, glm::vec3(1.0f));
    for (size_t i = 0; i < colours_.size(); ++i) {
        if (colours_[i] == kNoColour) continue;
        for (int k = 0; k < 3; ++k)
            linear[i][k] = (float) decodeSrgb(std::min(colours_[i][k] / white, 1.0));
    }
    const auto isWhite = [](glm::vec3 colour) { return colour == glm::vec3(1.0f); };
    if (std::all_of(linear.begin(), linear.end(), isWhite)) linear.clear();
    return linear;
}

} // namespace dirt
