#include "core/io/gltf_transform.h"

#include <cmath>
#include <vector>

#include <glm/geometric.hpp>

namespace dirt {

namespace {

/// Exporters multiply matrices in float32, and write what of 0, 0, 0, 1 is left in the bottom row.
/// An entry of a product is a sum of four rounded products: of an affine row it is off by at most
/// 4 * 2^-24; four factors one after the other add that up to 2^-20.
constexpr double kRounding = 0x1p-20;

glm::dmat4 affine(const JsonValue& node, const std::vector<double>& values) {
    glm::dmat4 matrix;
    for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = values[(size_t) i];
    for (int column = 0; column < 4; ++column) {
        const double right = column == 3 ? 1.0 : 0.0;
        if (!(std::abs(matrix[column][3] - right) <= kRounding))
            node.fail("has a matrix that is not affine");
        matrix[column][3] = right;
    }
    return matrix;
}

} // namespace

glm::dmat4 gltfTransform(const JsonValue& from, glm::dvec3 translation, glm::dquat rotation,
                         glm::dvec3 scale) {
    if (!(glm::length(rotation) > 0.0)) from.fail("has a rotation of no length");
    glm::dmat4 matrix = glm::mat4_cast(glm::normalize(rotation));
    for (int i = 0; i < 3; ++i) matrix[i] *= scale[i];
    matrix[3] = glm::dvec4(translation, 1.0);
    return matrix;
}

glm::dmat4 gltfTransformOf(const JsonValue& node) {
    if (const auto values = node.numbers("matrix", 16)) return affine(node, *values);
    glm::dvec3 translation(0.0), scale(1.0);
    glm::dquat rotation(1.0, 0.0, 0.0, 0.0);
    if (const auto t = node.numbers("translation", 3)) translation = {(*t)[0], (*t)[1], (*t)[2]};
    if (const auto r = node.numbers("rotation", 4)) rotation = {(*r)[3], (*r)[0], (*r)[1], (*r)[2]};
    if (const auto s = node.numbers("scale", 3)) scale = {(*s)[0], (*s)[1], (*s)[2]};
    return gltfTransform(node, translation, rotation, scale);
}

} // namespace dirt
