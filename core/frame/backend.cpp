#include "core/frame/backend.h"

#include "core/frame/pass_clock.h"

namespace dirt {

namespace {

/// The order of the construction. \p fillTriangles begins FillDepth.
template <typename FillTriangles>
std::vector<PassTime> construct(Backend& backend, const Camera& camera,
                                const GridSettings& settings, const FillTriangles& fillTriangles) {
    PassClock clock(backend);
    clock.time("Clear", 0, [&] { backend.clear(camera, settings); });
    clock.time("FillDepth", 0, [&] {
        fillTriangles();
        backend.fillDepth();
    });
    clock.time("FillDepthMipmap", 0, [&] { backend.fillDepthMipmap(); });
    clock.time("FillPrimitives", 0, [&] { backend.fillPrimitives(); });
    return clock.take();
}

} // namespace

PathBuffers Backend::readPath(size_t pixel) const {
    return readPaths().only(pixel);
}

std::vector<PassTime> Backend::build(const Mesh& mesh, const Camera& camera,
                                     const GridSettings& settings) {
    return construct(*this, camera, settings, [&] { transform(mesh, camera, settings.mode); });
}

std::vector<PassTime> Backend::build(const FrameGeometry& geometry, const Camera& camera,
                                     const GridSettings& settings) {
    return construct(*this, camera, settings, [&] { setGeometry(geometry); });
}

} // namespace dirt
