#include "backend_cpu/image/direct_visibility.h"

#include "backend_cpu/image/eye_tile.h"
#include "backend_cpu/image/prefetch_texels.h"
#include "core/base/denormals.h"
#include "core/grid/repeated.h"
#include "core/path/fetch_surface.h"
#include "core/path/sub_pixel.h"
#include "core/trace/intersect.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <optional>
#include <vector>

#include <glm/geometric.hpp>

namespace dirt {
namespace {

constexpr size_t kCulledPerPiece = 2048;

/// The camera rays of one sample.
class SampleRays {
public:
    SampleRays(const FrameContext& frame, uint32_t sample)
        : camera_(frame.camera), offset_(subPixelOffset(sample, frame.settings.seed)) {}

    glm::vec2 offset() const { return offset_; }
    glm::vec3 direction(int x, int y) const {
        const glm::vec3 d = camera_.through((float) x + offset_.x, (float) y + offset_.y).direction;
        return {flushed(d.x), flushed(d.y), flushed(d.z)};
    }

    /// Directions are R x + D y + F, x and y slopes of at most S. Each slope is off by 3 u S, each
    /// component by less than 16 u (1 + 2 S), u = 2^-24; of an edge's value between four pixels
    /// this takes twice that, 2^-19 (1 + 2 S).
    EyeRays bounds(int width, int height) const {
        const ImagePlane& plane = camera_.plane();
        EyeRays rays{};
        rays.forward = glm::dvec3(plane.forward);
        for (int corner = 0; corner < 4; ++corner) {
            const glm::vec3 d = direction(corner & 1 ? width : 0, corner & 2 ? height : 0);
            for (int i = 0; i < 3; ++i) rays.reach = std::max(rays.reach, std::abs(d[i]));
            rays.most = std::max(rays.most, glm::dot(glm::dvec3(d), rays.forward));
        }
        const float slope = std::max(std::abs(plane.slopeX), std::abs(plane.slopeY));
        const float noise = 0x1p-18f * (1.0f + 2.0f * slope); // twice as above
        rays.reach += noise;
        rays.most += 3.0 * noise;
        rays.margin = 6.0f * 0x1p-24f * rays.reach; // of three products
        rays.spread = noise + rays.margin;
        return rays;
    }

private:
    const CameraRays& camera_;
    glm::vec2 offset_;
};

/// The image's tiles, and the triangles in each in the order of depth.
class TiledTriangles {
public:
    TiledTriangles(const FrameContext& frame, const SampleRays& rays, Executor& executor,
                   EyeBuffers& buffers)
        : buffers_(buffers), width_(frame.settings.grid.width), height_(frame.settings.grid.height),
          columns_((width_ + EyeTile::kWidth - 1) / EyeTile::kWidth),
          rows_((height_ + EyeTile::kHeight - 1) / EyeTile::kHeight),
          bounds_(rays.bounds(width_, height_)) {
        for (int row = 0; row <= rows_; ++row)
            for (int column = 0; column <= columns_; ++column)
                corners_.push_back(rays.direction(std::min(column * EyeTile::kWidth, width_),
                                                  std::min(row * EyeTile::kHeight, height_)));
        const GridSettings& grid = frame.settings.grid;
        const ImageFootprint footprint(frame.scene.camera, grid.width, grid.height, grid.mode,
                                       rays.offset());
        const auto& triangles = frame.geometry.triangles;
        std::vector<EyeBuffers::Piece>& pieces = buffers.pieces;
        pieces.resize((triangles.size() + kCulledPerPiece - 1) / kCulledPerPiece);
        const ImageCull cull = footprint.cull();
        executor.forRange(triangles.size(), kCulledPerPiece, [&](size_t begin, size_t end) {
            EyeBuffers::Piece& piece = pieces[begin / kCulledPerPiece];
            piece.items.clear();
            piece.fragments.clear();
            uint32_t kept[kCulledPerPiece + kKeptPadding];
            const size_t count =
                keepInImage(cull, std::span(triangles).subspan(begin, end - begin), kept);
            for (size_t i = 0; i < count; ++i) {
                const size_t id = begin + kept[i];
                if (isRepeated(frame.geometry, id)) continue;
                const PixelRange range = footprint(triangles[id]);
                if (range.x0 > range.x1 || range.y0 > range.y1) continue;
                place(EyeTriangle(triangles[id], (uint32_t) id, range, bounds_), piece);
            }
        });
        std::vector<FragmentPiece> fragments;
        size_t sum = 0;
        for (const EyeBuffers::Piece& piece : pieces) {
            fragments.push_back({piece.fragments, (uint32_t) sum});
            sum += piece.items.size();
        }
        buffers.items.resize(sum);
        executor.forRange(pieces.size(), 1, [&](size_t piece, size_t) {
            std::copy(pieces[piece].items.begin(), pieces[piece].items.end(),
                      buffers.items.begin() + fragments[piece].firstItem);
        });
        sortIntoTiles(fragments, (size_t) tiles(), executor, buffers.lists);
    }

    int tiles() const { return columns_ * rows_; }

    /// What the pixels of a tile see.
    void fill(const FrameContext& frame, const SampleRays& rays, int index, EyeTile& tile) const {
        tile.x0 = index % columns_ * EyeTile::kWidth;
        tile.y0 = index / columns_ * EyeTile::kHeight;
        for (int pixel = 0; pixel < EyeTile::kPixels; ++pixel) {
            const int x = tile.x0 + pixel % EyeTile::kWidth;
            const int y = tile.y0 + pixel / EyeTile::kWidth;
            const glm::vec3 d = rays.direction(x, y);
            for (int i = 0; i < 3; ++i) tile.direction[i][pixel] = d[i];
            const bool outside = x >= width_ || y >= height_;
            tile.low[pixel] = tile.high[pixel] = outside ? HUGE_VALF : -HUGE_VALF;
            tile.id[pixel] = kNoPrimitive;
        }
        rasterizeTile(frame.geometry, buffers_.items, buffers_.lists.list((size_t) index),
                      bounds_.margin, tile);
    }

private:
    void place(const EyeTriangle& item, EyeBuffers::Piece& piece) const {
        const int column0 = item.range.x0 / EyeTile::kWidth;
        const int column1 = item.range.x1 / EyeTile::kWidth;
        const int row0 = item.range.y0 / EyeTile::kHeight;
        const int row1 = item.range.y1 / EyeTile::kHeight;
        const bool one = column0 == column1 && row0 == row1;
        const size_t before = piece.fragments.size();
        for (int row = row0; row <= row1; ++row)
            for (int column = column0; column <= column1; ++column) {
                const size_t corner = (size_t) row * (columns_ + 1) + column;
                const size_t below = corner + columns_ + 1;
                if (!one && item.misses({corners_[corner], corners_[corner + 1], corners_[below],
                                         corners_[below + 1]},
                                        bounds_.spread))
                    continue;
                piece.fragments.push_back({(uint32_t) (row * columns_ + column),
                                           (uint32_t) piece.items.size(), item.near});
            }
        if (piece.fragments.size() > before) piece.items.push_back(item);
    }

    const EyeBuffers& buffers_;
    int width_, height_, columns_, rows_;
    EyeRays bounds_;
    std::vector<glm::vec3> corners_; ///< directions at the tiles' corners
};

/// The hit triangles of one tile, made ready for the rays from the eye: a triangle mostly has
/// several pixels.
class SeenTriangles {
public:
    void clear() { std::fill(std::begin(ids_), std::end(ids_), kNoPrimitive); }

    /// core's `intersect` from the eye.
    void intersect(const FrameGeometry& geometry, uint32_t id, glm::vec3 direction,
                   TriangleHit& hit) {
        std::optional<TriangleFrom>& triangle = triangles_[id % kCount];
        if (ids_[id % kCount] != id) {
            ids_[id % kCount] = id;
            triangle.emplace(glm::vec3(0.0f), geometry.triangles[id]);
        }
        triangle->intersect(direction, hit);
    }

private:
    static constexpr size_t kCount = 64;

    uint32_t ids_[kCount];
    std::optional<TriangleFrom> triangles_[kCount];
};

/// Calls visit(pixel of the image, ray, id, hit) for each pixel, with kNoPrimitive for nothing;
/// some pixels earlier expect(id, hit), where there is one. Returns how many see something.
template <class Expect, class Visit>
size_t forEachHit(const FrameContext& frame, Executor& executor, uint32_t sample,
                  EyeBuffers& buffers, const Expect& expect, const Visit& visit) {
    const int width = frame.settings.grid.width, height = frame.settings.grid.height;
    const SampleRays rays(frame, sample);
    const TiledTriangles tiled(frame, rays, executor, buffers);
    std::atomic<size_t> hits = 0;
    executor.forRange((size_t) tiled.tiles(), 1, [&](size_t index, size_t) {
        thread_local EyeTile tile;
        thread_local SeenTriangles seen;
        tiled.fill(frame, rays, (int) index, tile);
        seen.clear();
        size_t found = 0;
        const int columns = std::min(EyeTile::kWidth, width - tile.x0);
        for (int y = 0; y < std::min(EyeTile::kHeight, height - tile.y0); ++y) {
            TriangleHit row[EyeTile::kWidth];
            const uint32_t* const ids = tile.id + y * EyeTile::kWidth;
            const auto rayAt = [&](int x) { return tile.ray(y * EyeTile::kWidth + x); };
            for (int x = 0; x < columns; ++x) {
                if (ids[x] == kNoPrimitive) continue;
                ++found;
                seen.intersect(frame.geometry, ids[x], rayAt(x).direction, row[x]);
                expect(ids[x], row[x]);
            }
            const size_t first = (size_t) (tile.y0 + y) * width + tile.x0;
            for (int x = 0; x < columns; ++x) visit(first + x, rayAt(x), ids[x], row[x]);
        }
        hits += found;
    });
    return hits;
}

} // namespace

size_t rasterizeDirectVisibility(const FrameContext& frame, Executor& executor, uint32_t sample,
                                 EyeBuffers& buffers, PathBuffers& paths) {
    const auto expect = [&](uint32_t id, const TriangleHit& hit) {
        prefetchTexels(frame.scene, id, hit.u, hit.v);
    };
    return forEachHit(frame, executor, sample, buffers, expect,
                      [&](size_t pixel, const Ray& ray, uint32_t id, const TriangleHit& hit) {
                          if (id == kNoPrimitive)
                              paths.clearNext(pixel);
                          else
                              paths.setNext(pixel,
                                            fetchSurface(frame.scene, frame.geometry, ray.direction,
                                                         id, hit.u, hit.v),
                                            frame.geometry);
                      });
}

void rasterizeHits(const FrameContext& frame, Executor& executor, uint32_t sample,
                   EyeBuffers& buffers, std::span<Hit> hits) {
    const auto expect = [](uint32_t, const TriangleHit&) {};
    forEachHit(frame, executor, sample, buffers, expect,
               [&](size_t pixel, const Ray&, uint32_t id, const TriangleHit& hit) {
                   hits[pixel] = {};
                   if (id != kNoPrimitive) hits[pixel] = {id, hit.t, hit.u, hit.v, 0, 0};
               });
}

} // namespace dirt
