#include "core/frame/transform_mesh.h"

#include "core/base/denormals.h"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace dirt {
namespace {

constexpr size_t kMovedAtOnce = 8192;

static_assert(sizeof(Triangle) == 9 * sizeof(float));

/// The bits of |x|. They order as magnitudes do, infinity and then NaN above all numbers.
uint32_t magnitude(float x) {
    return std::bit_cast<uint32_t>(x) & 0x7fffffffu;
}

} // namespace

void transformMesh(const Mesh& mesh, const Camera& camera, ViewMode mode, Executor& executor,
                   FrameGeometry& geometry) {
    const size_t count = mesh.triangles.size();
    GridFrame& frame = geometry.frame;
    frame = makeUnscaledFrame(camera, mode);
    geometry.triangles.resize(count);
    // Denormals count before the scale, which may make normal numbers of them.
    std::vector<uint32_t> largest((count + kMovedAtOnce - 1) / kMovedAtOnce);
    executor.forRange(count, kMovedAtOnce, [&](size_t begin, size_t end) {
        const KeepDenormals keep;
        uint32_t most = 0;
        for (size_t i = begin; i < end; ++i) {
            glm::vec3* const vertices[3] = {&geometry.triangles[i].a, &geometry.triangles[i].b,
                                            &geometry.triangles[i].c};
            for (int k = 0; k < 3; ++k) {
                glm::vec3 p = mesh.positions[mesh.triangles[i][k]] - frame.eye;
                if (mode == ViewMode::single) p = frame.directionToGrid(p);
                most = std::max({most, magnitude(p.x), magnitude(p.y), magnitude(p.z)});
                *vertices[k] = p;
            }
        }
        largest[begin / kMovedAtOnce] = most;
    });
    const uint32_t most = count == 0 ? 0 : *std::max_element(largest.begin(), largest.end());
    frame.scale = scaleFor(std::bit_cast<float>(most));
    const float scale = frame.scale;
    auto* const floats = reinterpret_cast<float*>(geometry.triangles.data());
    executor.forRange(count, kMovedAtOnce, [&](size_t begin, size_t end) {
        const KeepDenormals keep;
        for (size_t i = 9 * begin; i < 9 * end; ++i) floats[i] = flushed(floats[i] * scale);
    });
}

} // namespace dirt
