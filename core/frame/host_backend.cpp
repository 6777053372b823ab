#include "core/frame/host_backend.h"

#include "core/frame/shadow_raster.h"
#include "core/frame/transform_mesh.h"

#include <algorithm>
#include <stdexcept>

namespace dirt {

void HostBackend::transform(const Mesh& mesh, const Camera& camera, ViewMode mode) {
    transformMesh(mesh, camera, mode, executor_, transformed_);
    transformed_.cutOuts = nullptr; // until the frame begins
    geometry_ = &transformed_;
    triangleBytes_ = transformed_.triangles.size() * sizeof(Triangle);
}

void HostBackend::setGeometry(const FrameGeometry& geometry) {
    transformed_.triangles.clear(); // but keeps its memory
    geometry_ = &geometry;
    triangleBytes_ = geometry.triangles.size() * sizeof(Triangle);
}

void HostBackend::beginFrame(const Scene& scene, const RenderSettings& settings,
                             const Requirements& requirements) {
    transformed_.cutOuts = requirements.cutOuts ? &scene : nullptr;
    frame_.emplace(scene, *geometry_, settings, requirements);
    paths_.allocate(requirements, (size_t) settings.grid.width * (size_t) settings.grid.height);
    if (!frame_->shadowMap) shadowDepths_ = {};
    counts_ = {};
}

void HostBackend::shadowMap() {
    rasterizeShadowMap(*geometry_, *frame_->light, *frame_->shadowMap, executor_, shadowDepths_);
}

void HostBackend::beginSample() {
    std::fill(paths_.radiance.begin(), paths_.radiance.end(), glm::vec3(0.0f));
}

void HostBackend::directVisibility(uint32_t) {
    throw std::logic_error(name() + " does not rasterize");
}

void HostBackend::depthMask(int event) {
    passDepthMask(*frame_, executor_, event, paths_);
}

void HostBackend::rays(uint32_t sample, int event) {
    passRays(*frame_, executor_, sample, event, paths_);
}

void HostBackend::trace(int event) {
    passTrace(*frame_, executor_, *this, event, paths_, counts_);
}

void HostBackend::fetch(int) {
    passFetch(*frame_, executor_, paths_);
}

void HostBackend::visibility(int event) {
    passVisibility(*frame_, executor_, *this, event, paths_, counts_);
}

void HostBackend::shade(int event) {
    passShade(*frame_, executor_, event, shadowDepths_, paths_);
}

void HostBackend::shift() {
    passShift(paths_);
}

void HostBackend::resolve() {
    passResolve(executor_, paths_, counts_);
}

void HostBackend::writePaths(const PathBuffers& paths) {
    paths_ = paths.packed(frame_ ? pointFormatOf(frame_->requirements) : PointFormat{}, *geometry_);
}

std::vector<SurfacePoint> HostBackend::readPoints() const {
    return paths_.packedNext.empty() ? paths_.next : unpack(paths_.packedNext, *geometry_);
}

Grid HostBackend::readGrid() const {
    throw std::logic_error(name() + " has no grid");
}

void HostBackend::writeGrid(const Grid&) {
    throw std::logic_error(name() + " has no grid");
}

std::vector<BufferSize> HostBackend::memory() const {
    std::vector<BufferSize> sizes = {{"triangle buffer", triangleBytes_}};
    for (BufferSize& size : paths_.sizes()) sizes.push_back(std::move(size));
    if (!shadowDepths_.empty())
        sizes.emplace_back("shadow map", shadowDepths_.size() * sizeof(float));
    return sizes;
}

} // namespace dirt
