#include "core/verify/verify_extremes.h"

#include "core/base/error.h"
#include "core/base/finite.h"
#include "core/frame/renderer.h"
#include "core/frame/requirements.h"
#include "core/frame/transform_mesh.h"
#include "core/verify/closed_bodies.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace dirt {

namespace {

void add(const BackendReport& from, BackendReport& to) {
    to.missed += from.missed;
    to.falseHits += from.falseHits;
    to.wrongPrimitive += from.wrongPrimitive;
    to.maxRelativeTError = std::max(to.maxRelativeTError, from.maxRelativeTError);
    to.maxUlpTError = std::max(to.maxUlpTError, from.maxUlpTError);
    to.traceMs += from.traceMs;
}

} // namespace

bool ExtremeBackendReport::right() const {
    return rays.errors() == 0 && rays.maxUlpTError <= kMostUlps && nonFinitePixels == 0 &&
           leaks.value_or(0) == 0 && selfShadows.value_or(0) == 0;
}

ExtremeVerifier::ExtremeVerifier(Scene scene, const RenderSettings& settings,
                                 std::vector<Backend*> backends, const VerifySettings& verify,
                                 Executor& executor)
    : scene_(std::move(scene)), original_{scene_.mesh, scene_.camera, scene_.lights,
                                          scene_.materials, scene_.background},
      settings_(settings), changed_(settings), backends_(std::move(backends)), verify_(verify),
      executor_(executor) {
    if (scene_.mesh.triangles.empty())
        throw InputError("--extremes: the scene has no triangles to make variants of");
    scene_.animation = {};
    verify_.anyHits = true;
}

void ExtremeVerifier::derive(const Extreme& extreme) {
    scene_.mesh = original_.mesh;
    scene_.camera = original_.camera;
    scene_.lights = original_.lights;
    scene_.materials = original_.materials;
    scene_.background = original_.background;
    changed_ = settings_;
    changed_.samples = 1;
    extreme_ = &extreme;
    extreme.derive(scene_, changed_.grid);
}

std::vector<uint32_t> ExtremeVerifier::changedTriangles() const {
    const Mesh &before = original_.mesh, &after = scene_.mesh;
    const auto old = (uint32_t) std::min(before.triangles.size(), after.triangles.size());
    std::vector<uint32_t> ids(after.triangles.size() - old);
    std::iota(ids.begin(), ids.end(), old);
    if (!ids.empty()) return ids;
    for (uint32_t id = 0; id < old; id++) {
        const auto moved = [&](uint32_t corner) {
            return after.positions[corner] != before.positions[corner];
        };
        const Corners& corners = after.triangles[id];
        if (std::any_of(corners.begin(), corners.end(), moved)) ids.push_back(id);
    }
    return ids;
}

ExtremeReport ExtremeVerifier::run(const Extreme& extreme, std::span<const RayKind> kinds) {
    ExtremeReport report;
    report.extreme = &extreme;
    report.backends.resize(backends_.size());
    try {
        derive(extreme);
        report.triangles = scene_.mesh.triangles.size();
        const bool hasHoles = requirementsOf(scene_, changed_, false).cutOuts;
        FrameGeometry geometry;
        transformMesh(scene_.mesh, scene_.camera, changed_.grid.mode, executor_, geometry);
        for (size_t b = 0; b < backends_.size(); b++) {
            renderFrame(*backends_[b], report.backends[b]);
            // The frame's structure is that of this geometry, if its arithmetic is (G7) and no
            // holes are looked up.
            if (hasHoles || !backends_[b]->isIeee())
                backends_[b]->build(geometry, scene_.camera, changed_.grid);
            probeBody(*backends_[b], geometry, report.backends[b]);
        }
        castRays(geometry, kinds, report);
    } catch (const InputError& error) {
        report.leftOut = error.what();
    }
    return report;
}

void ExtremeVerifier::castRays(const FrameGeometry& geometry, std::span<const RayKind> kinds,
                               ExtremeReport& report) {
    Verifier verifier(geometry, scene_.camera, changed_.grid, {backends_.begin(), backends_.end()},
                      verify_, executor_);
    for (const RayKind kind : report.extreme->kinds) {
        if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end()) continue;
        const KindReport ofKind = verifier.run(kind);
        report.rays += ofKind.rays;
        report.hits += ofKind.hits;
        for (size_t b = 0; b < backends_.size(); b++)
            add(ofKind.backends[b], report.backends[b].rays);
        for (const WrongAnswer& wrong : ofKind.wrong)
            if (report.wrong.size() < verify_.shownWrongAnswers) report.wrong.push_back(wrong);
    }
}

void ExtremeVerifier::renderFrame(Backend& backend, ExtremeBackendReport& report) {
    const Image image = Renderer(scene_, changed_, backend).render().image;
    const auto count = [&](auto&& counts) {
        return (uint64_t) std::count_if(image.pixels.begin(), image.pixels.end(), counts);
    };
    report.nonFinitePixels = count([](glm::vec3 pixel) { return !isFinite(pixel); });
    if (extreme_->body == Extreme::Body::closedBox)
        report.leaks = count([](glm::vec3 pixel) { return pixel != glm::vec3(0.0f); });
}

void ExtremeVerifier::probeBody(Backend& backend, const FrameGeometry& geometry,
                                ExtremeBackendReport& report) {
    if (extreme_->body == Extreme::Body::closedBox) {
        const auto leaks = countLeaks(backend, geometry, scene_, verify_.rays, verify_.seed);
        if (leaks) *report.leaks += *leaks;
    }
    if (extreme_->body == Extreme::Body::ball)
        report.selfShadows =
            countSelfShadows(backend, geometry, scene_, verify_.rays, verify_.seed);
}

} // namespace dirt
