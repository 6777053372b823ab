#pragma once

#include "core/frame/requirements.h"
#include "core/grid/geometry.h"
#include "shaders/shared/packed_point.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace dirt {

/// The words of a PackedPoint that a frame keeps: those that every point has, and where it has need
/// of them the others.
struct PointFormat {
    uint32_t words = 0;                           ///< of a point; 0: points are kept in full
    uint32_t normal = 0, emission = 0, gloss = 0; ///< place of the word; 0: there is none

    bool packed() const { return words > 0; }
    /// Of a point.
    size_t bytes() const { return packed() ? words * sizeof(uint32_t) : sizeof(SurfacePoint); }
};

PointFormat pointFormatOf(const Requirements& requirements);

/// Packed surface points, one a pixel.
class PackedPoints {
public:
    /// Of a point in a scene that needs nothing more.
    static constexpr size_t kLeastBytes = 5 * sizeof(uint32_t);

    PackedPoints() = default;
    PackedPoints(const PointFormat& format, size_t pixels);
    /// \p words: as they are kept.
    PackedPoints(const PointFormat& format, std::vector<uint32_t> words)
        : format_(format), words_(std::move(words)) {}

    bool empty() const { return words_.empty(); }
    size_t size() const { return empty() ? 0 : words_.size() / format_.words; }
    const std::vector<uint32_t>& words() const { return words_; }

    bool found(size_t pixel) const { return words_[pixel * format_.words] != kNoPrimitive; }
    PackedPoint operator[](size_t pixel) const;
    void set(size_t pixel, const PackedPoint& point);
    /// The point of one pixel alone.
    PackedPoints only(size_t pixel) const;

    void swap(PackedPoints& other) {
        std::swap(format_, other.format_);
        words_.swap(other.words_);
    }

private:
    PointFormat format_;
    std::vector<uint32_t> words_;
};

PackedPoint packPoint(const SurfacePoint& point, const FrameGeometry& geometry);
SurfacePoint unpackPoint(const PackedPoint& packed, const FrameGeometry& geometry);

std::vector<SurfacePoint> unpack(const PackedPoints& points, const FrameGeometry& geometry);
PackedPoints pack(const std::vector<SurfacePoint>& points, const PointFormat& format,
                  const FrameGeometry& geometry);

/// A point of one of the three buffers, of which either \p full or \p packed has something.
class StoredPoint {
public:
    StoredPoint(const FrameGeometry& geometry, const std::vector<SurfacePoint>& full,
                const PackedPoints& packed, size_t pixel) {
        if (packed.empty()) {
            point_ = &full[pixel];
        } else {
            unpacked_ = unpackPoint(packed[pixel], geometry);
            point_ = &*unpacked_;
        }
    }
    StoredPoint(const StoredPoint&) = delete;
    StoredPoint& operator=(const StoredPoint&) = delete;

    const SurfacePoint& operator*() const { return *point_; }
    const SurfacePoint* operator->() const { return point_; }

private:
    std::optional<SurfacePoint> unpacked_;
    const SurfacePoint* point_;
};

} // namespace dirt
