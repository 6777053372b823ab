#pragma once

#include "core/frame/forwarding_backend.h"
#include "core/frame/passes.h"
#include "core/path/fetch_surface.h"
#include "core/path/sub_pixel.h"
#include "core/trace/intersect.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>

namespace dirt::test {

/// Rasterizes direct visibility as graphics hardware does: clips at a near plane, moves vertices to
/// a raster of 1/256 of a pixel, interpolates 1/w over the moved triangle, and keeps the nearest.
class SnappingBackend final : public ForwardingBackend {
public:
    /// \p raster: positions along a pixel; 256 as real hardware has.
    SnappingBackend(Backend& inner, double raster) : ForwardingBackend(inner), raster_(raster) {}

    std::string name() const override { return "snapping"; }
    void beginFrame(const Scene& scene, const RenderSettings& settings,
                    const Requirements& requirements) override {
        geometry_ = inner_.readGeometry();
        frame_.emplace(scene, geometry_, settings, requirements);
        inner_.beginFrame(scene, settings, requirements);
    }
    void directVisibility(uint32_t sample) override {
        const GridSettings& image = frame_->settings.grid;
        const glm::vec2 offset = subPixelOffset(sample, frame_->settings.seed);
        const auto pixels = (size_t) image.width * (size_t) image.height;
        std::vector<double> nearest(pixels, 0.0); // 1/w
        std::vector<uint32_t> seen(pixels, kNoPrimitive);
        for (uint32_t id = 0; id < geometry_.triangles.size(); ++id)
            for (const auto& corners : clipped(geometry_.triangles[id]))
                draw(corners, glm::dvec2(offset), [&](int x, int y, double nearness) {
                    const size_t pixel = (size_t) y * (size_t) image.width + (size_t) x;
                    if (nearness > nearest[pixel]) {
                        nearest[pixel] = nearness;
                        seen[pixel] = id;
                    }
                });

        PathBuffers paths = inner_.readPaths();
        for (size_t i = 0; i < pixels; ++i) {
            paths.next[i] = {};
            if (seen[i] == kNoPrimitive) continue;
            const Ray ray = frame_->camera.through((float) (i % (size_t) image.width) + offset.x,
                                                   (float) (i / (size_t) image.width) + offset.y);
            TriangleHit hit{0.0f, 1.0f / 3.0f, 1.0f / 3.0f};
            dirt::intersect(ray, geometry_.triangles[seen[i]], hit);
            paths.next[i] =
                fetchSurface(frame_->scene, geometry_, ray.direction, seen[i], hit.u, hit.v);
        }
        inner_.writePaths(paths);
    }

private:
    /// In the frame of the camera: right, down, forward.
    using Corners = std::array<glm::dvec3, 3>;

    std::vector<Corners> clipped(const Triangle& triangle) const {
        const GridFrame& frame = geometry_.frame;
        const CameraBasis basis = frame.mode == ViewMode::full
                                      ? cameraBasis(frame_->scene.camera)
                                      : CameraBasis{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        std::vector<glm::dvec3> in, out;
        for (const glm::vec3 p : {triangle.a, triangle.b, triangle.c})
            in.emplace_back(glm::dot(glm::dvec3(basis.right), glm::dvec3(p)),
                            glm::dot(glm::dvec3(basis.down), glm::dvec3(p)),
                            glm::dot(glm::dvec3(basis.forward), glm::dvec3(p)));
        constexpr double near = 1e-5;
        for (size_t i = 0; i < in.size(); ++i) {
            const glm::dvec3 a = in[i], b = in[(i + 1) % in.size()];
            if (a.z >= near) out.push_back(a);
            if ((a.z >= near) != (b.z >= near)) {
                out.push_back(a + (b - a) * ((near - a.z) / (b.z - a.z)));
                out.back().z = near;
            }
        }
        std::vector<Corners> triangles;
        for (size_t i = 2; i < out.size(); ++i) triangles.push_back({out[0], out[i - 1], out[i]});
        return triangles;
    }

    template <typename Emit>
    void draw(const Corners& corners, glm::dvec2 offset, const Emit& emit) const {
        const GridSettings& image = frame_->settings.grid;
        const double slope = std::tan(frame_->scene.camera.verticalFov * std::acos(-1.0) / 360.0);
        glm::dvec2 p[3]; // relative to the samples of the pixels
        double nearness[3];
        for (int i = 0; i < 3; ++i) {
            const glm::dvec2 at =
                glm::dvec2(corners[i]) / (corners[i].z * slope) * (image.height * 0.5) +
                glm::dvec2(image.width, image.height) * 0.5 - offset;
            p[i] = glm::round(at * raster_) / raster_;
            nearness[i] = 1.0 / corners[i].z;
        }
        const auto cross = [](glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; };
        const double area = cross(p[1] - p[0], p[2] - p[0]);
        if (area == 0.0) return;
        const glm::dvec2 lo = glm::min(p[0], glm::min(p[1], p[2])),
                         hi = glm::max(p[0], glm::max(p[1], p[2]));
        for (int y = (int) std::max(0.0, std::ceil(lo.y));
             y <= (int) std::min(image.height - 1.0, std::floor(hi.y)); ++y)
            for (int x = (int) std::max(0.0, std::ceil(lo.x));
                 x <= (int) std::min(image.width - 1.0, std::floor(hi.x)); ++x) {
                double weights[3], sum = 0.0;
                for (int i = 0; i < 3; ++i) {
                    const glm::dvec2 a = p[(i + 1) % 3], b = p[(i + 2) % 3];
                    weights[i] = cross(b - a, glm::dvec2(x, y) - a) / area;
                    sum += weights[i] * nearness[i];
                }
                if (weights[0] >= 0.0 && weights[1] >= 0.0 && weights[2] >= 0.0) emit(x, y, sum);
            }
    }

    double raster_;
    FrameGeometry geometry_;
    std::optional<FrameContext> frame_;
};

} // namespace dirt::test
