#include "core/frame/transform_mesh.h"

#include "core/grid/denormals.h"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace dirt {
namespace {

constexpr size_t kTrianglesPerPiece = 8192;

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
    std::vector<uint32_t> largest((count + kTrianglesPerPiece - 1) / kTrianglesPerPiece);
    executor.forRange(count, kTrianglesPerPiece, [&](size_t begin, size_t end) {
        const KeepDenormals keep;
        uint32_t most = 0;
        for (size_t i = begin; i < end; ++i)
            for (const uint32_t corner : mesh.triangles[i]) {
                const glm::vec3 p = frame.directionToGrid(mesh.positions[corner] - frame.eye);
                most = std::max({most, magnitude(p.x), magnitude(p.y), magnitude(p.z)});
            }
        largest[begin / kTrianglesPerPiece] = most;
    });
    const uint32_t most = count == 0 ? 0 : *std::max_element(largest.begin(), largest.end());
    frame.scale = scaleFor(std::bit_cast<float>(most));
    executor.forRange(count, kTrianglesPerPiece, [&](size_t begin, size_t end) {
        const KeepDenormals keep;
        for (size_t i = begin; i < end; ++i) {
            const Corners& corners = mesh.triangles[i];
            geometry.triangles[i] = {frame.toGrid(mesh.positions[corners[0]]),
                                     frame.toGrid(mesh.positions[corners[1]]),
                                     frame.toGrid(mesh.positions[corners[2]])};
        }
    });
}

} // namespace dirt
