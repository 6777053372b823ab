#pragma once

#include "core/frame/host_backend.h"
#include "core/frame/shadow_raster.h"
#include "core/grid/scan.h"
#include "core/path/fetch_surface.h"
#include "core/path/sub_pixel.h"
#include "core/trace/traverse.h"

namespace dirt::test {

/// Every pass as core defines it, one entry after the other: what any backend can be held against.
class PlainBackend final : public HostBackend {
public:
    explicit PlainBackend(Executor& executor) : HostBackend(executor) {}

    std::string name() const override { return "plain"; }
    std::string device() const override { return "host"; }

    void clear(const Camera& camera, const GridSettings& settings) override {
        grid_ = makeEmptyGrid(camera, settings);
        emptyLists();
    }
    void fillDepth() override {
        forEachPart([this](size_t view, size_t tile, uint32_t, const DepthInterval& depths) {
            grid_.pyramids[view].levels[0].bounds[tile].include(depths.near, depths.far);
        });
    }
    void fillDepthMipmap() override {
        for (DepthPyramid& pyramid : grid_.pyramids) buildPyramid(pyramid);
    }
    void fillPrimitives() override {
        std::vector<std::vector<uint32_t>> lists(cells());
        forEachPart([&](size_t view, size_t tile, uint32_t id, const DepthInterval& depths) {
            const BinMap map(grid_.bounds((int) view, (int) tile), grid_.settings.bins);
            for (int bin = map(depths.near); bin <= map(depths.far); ++bin)
                lists[grid_.cell((int) view, (int) tile, bin)].push_back(id);
        });
        emptyLists();
        for (size_t cell = 0; cell < lists.size(); ++cell) {
            grid_.ids.insert(grid_.ids.end(), lists[cell].begin(), lists[cell].end());
            grid_.heads[cell + 1] = (uint32_t) grid_.ids.size();
        }
        grid_.atEye = trianglesAtEye(*geometry_);
    }

    void intersect(std::span<const Ray> rays, std::span<Hit> hits) override {
        for (size_t i = 0; i < rays.size(); ++i) hits[i] = closestHit(grid_, *geometry_, rays[i]);
    }
    void occluded(std::span<const Ray> rays, std::span<const float> maxT,
                  std::span<uint8_t> result) override {
        for (size_t i = 0; i < rays.size(); ++i)
            result[i] = anyHit(grid_, *geometry_, rays[i], maxT[i]);
    }

    bool rasterizes() const override { return true; }
    /// By testing every triangle.
    void directVisibility(uint32_t sample) override {
        const GridSettings& image = frame_->settings.grid;
        const glm::vec2 offset = subPixelOffset(sample, frame_->settings.seed);
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x) {
                const Ray ray = frame_->camera.through((float) x + offset.x, (float) y + offset.y);
                const Hit hit = closestHitBruteForce(*geometry_, ray);
                SurfacePoint& point = paths_.next[(size_t) y * (size_t) image.width + (size_t) x];
                point = {};
                if (hit.found())
                    point = fetchSurface(frame_->scene, *geometry_, ray.direction, hit.primitive,
                                         hit.u, hit.v);
            }
    }

    void shadowMap() override {
        const uint32_t side = frame_->shadowMap->resolution;
        shadowDepths_.clear();
        for (uint32_t i = 0; i < side * side; ++i)
            shadowDepths_.push_back(
                shadowDepth(*geometry_, *frame_->light, *frame_->shadowMap, i % side, i / side));
    }

    bool hasGrid() const override { return true; }
    Grid readGrid() const override { return grid_; }
    void writeGrid(const Grid& grid) override { grid_ = grid; }

private:
    size_t cells() const { return (size_t) grid_.firstTile.back() * (size_t) grid_.settings.bins; }
    void emptyLists() {
        grid_.ids.clear();
        grid_.heads.assign(cells() + 1, 0);
    }
    template <typename Emit>
    void forEachPart(const Emit& emit) {
        for (uint32_t id = 0; id < geometry_->triangles.size(); ++id)
            for (size_t view = 0; view < grid_.views.size(); ++view)
                scanTriangle(geometry_->triangles[id], grid_.views[view],
                             [&](int tile, const DepthInterval& depths) {
                                 emit(view, (size_t) tile, id, depths);
                             });
    }

    Grid grid_;
};

} // namespace dirt::test
