#include "core/check/compare_paths.h"

#include "core/dump/channels.h"
#include "core/trace/intersect.h"
#include "core/verify/exact.h"
#include "shaders/shared/margins.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <utility>

namespace dirt {
namespace {

using Channels = std::vector<ChannelInfo>;

constexpr float kRelative = 1e-5f;
constexpr float kWeights = 0x1p-22f; // twice what intersect.h promises

bool isNumber(const ChannelInfo& info) {
    return info.channel.type == ExrChannel::Type::float32;
}

uint32_t word(const void* record, const ChannelInfo& info) {
    uint32_t bits;
    std::memcpy(&bits, static_cast<const std::byte*>(record) + info.offset, sizeof bits);
    return bits;
}

bool sameValue(const ChannelInfo& info, uint32_t a, uint32_t b) {
    return a == b || (isNumber(info) && std::bit_cast<float>(a) == std::bit_cast<float>(b));
}

/// Where arithmetic is not IEEE; \p a and \p b are the bits.
bool isClose(const ChannelInfo& info, uint32_t a, uint32_t b) {
    if (!isNumber(info)) return a == b;
    const float x = std::bit_cast<float>(a), y = std::bit_cast<float>(b);
    const float size = std::max(std::abs(x), std::abs(y));
    const std::string& name = info.channel.name;
    float allowed = kRelative * size;
    if (name == "t")
        allowed = kRelativeErrorT * size;
    else if (name == "u" || name == "v")
        allowed = kWeights;
    else if (info.space == "grid frame")
        allowed = kRelative * std::max(size, 1.0f);
    return std::abs(x - y) <= allowed;
}

/// A NaN or an infinity, which no pass may leave anywhere, not even both backends alike.
bool isNotFinite(const ChannelInfo& info, const void* record) {
    return isNumber(info) && (word(record, info) & 0x7f800000u) == 0x7f800000u;
}

bool isFinite(const Channels& channels, const void* record) {
    return std::none_of(channels.begin(), channels.end(),
                        [&](const ChannelInfo& info) { return isNotFinite(info, record); });
}

template <typename Compare>
bool allChannels(const Channels& channels, const void* a, const void* b, const Compare& compare) {
    return std::all_of(channels.begin(), channels.end(), [&](const ChannelInfo& info) {
        return compare(info, word(a, info), word(b, info));
    });
}

std::string text(const ChannelInfo& info, uint32_t bits) {
    if (!isNumber(info)) return bits == kNoPrimitive ? "none" : std::to_string(bits);
    char number[32];
    std::snprintf(number, sizeof number, "%.9g", (double) std::bit_cast<float>(bits));
    return number;
}

/// The channels that are not finite.
std::string notFinite(const Channels& channels, const void* record) {
    std::string all;
    for (const ChannelInfo& info : channels)
        if (isNotFinite(info, record))
            all += (all.empty() ? "" : ", ") + info.channel.name + " is " +
                   text(info, word(record, info));
    return all;
}

/// The channels that differ, with both values.
std::string differences(const Channels& channels, const void* expected, const void* found) {
    std::string all;
    for (const ChannelInfo& info : channels) {
        const uint32_t a = word(expected, info), b = word(found, info);
        if (sameValue(info, a, b)) continue;
        all += (all.empty() ? "" : ", ") + info.channel.name + " " + text(info, a) + ", not " +
               text(info, b);
    }
    return all;
}

/// Counts equal records; \p isAllowed(pixel) says whether others are within tolerance.
template <typename Record, typename IsAllowed>
void compareRecords(const std::vector<Record>& expected, const std::vector<Record>& found,
                    int width, const Channels& channels, const IsAllowed& isAllowed,
                    CheckRow& row) {
    row.compared += std::max(expected.size(), found.size());
    if (expected.size() != found.size()) {
        row.different += std::max(expected.size(), found.size()) - 1;
        row.differ({}, [&] {
            return std::to_string(expected.size()) + " records, not " +
                   std::to_string(found.size());
        });
        return;
    }
    for (size_t i = 0; i < expected.size(); ++i) {
        const Record &a = expected[i], &b = found[i];
        const Place pixel = Place::ofPixel((int) (i % (size_t) width), (int) (i / (size_t) width));
        const auto place = [&] {
            return "pixel " + std::to_string(pixel.x) + "," + std::to_string(pixel.y) + ": ";
        };
        if (!isFinite(channels, &b))
            row.differ(pixel, [&] { return place() + notFinite(channels, &b); });
        else if (std::memcmp(&a, &b, sizeof a) == 0 || allChannels(channels, &a, &b, sameValue))
            ++row.equal;
        else if (isAllowed(i))
            ++row.withinTolerance;
        else
            row.differ(pixel, [&] { return place() + differences(channels, &a, &b); });
    }
}

/// Flags of one byte each as words, which channels are made of.
std::vector<uint32_t> words(const std::vector<uint8_t>& flags) {
    return {flags.begin(), flags.end()};
}

/// Without the view and the tile that list the record.
Channels withoutTiles(Channels channels) {
    std::erase_if(channels, [](const ChannelInfo& info) {
        return info.channel.name == "view" || info.channel.name == "tile";
    });
    return channels;
}

} // namespace

std::string nameOf(PathBuffer buffer) {
    switch (buffer) {
    case PathBuffer::previous:
        return "shading buffer G[k-1]";
    case PathBuffer::current:
        return "shading buffer G[k]";
    case PathBuffer::next:
        return "shading buffer G[k+1]";
    case PathBuffer::mask:
        return "mask";
    case PathBuffer::rays:
        return "rays";
    case PathBuffer::hits:
        return "hit buffer";
    case PathBuffer::visibility:
        return "visibility";
    case PathBuffer::radiance:
        return "radiance";
    case PathBuffer::image:
        return "image";
    }
    return "";
}

PathComparison::PathComparison(const FrameGeometry& geometry, int width, PathTolerance tolerance)
    : geometry_(geometry), width_(width), tolerance_(std::move(tolerance)) {}

/// Which of two triangles at nearly the same t is found may depend on rounding.
bool PathComparison::areTied(const PathRay& ray, const Hit& a, const Hit& b) const {
    const size_t count = geometry_.triangles.size();
    if (a.primitive >= count || b.primitive >= count) return false;
    const Ray cast{ray.origin, ray.direction, ray.skip};
    const auto first = intersectExactly(cast, geometry_.triangles[a.primitive]);
    const auto second = intersectExactly(cast, geometry_.triangles[b.primitive]);
    return first && second && !exceeds(*first, *second, kRelativeErrorT) &&
           !exceeds(*second, *first, kRelativeErrorT);
}

void PathComparison::compareHits(const PathBuffers& expected, const PathBuffers& found,
                                 CheckRow& row) const {
    const Channels channels = tolerance_.tiles ? hitChannels() : withoutTiles(hitChannels());
    const auto isAllowed = [&](size_t pixel) {
        const Hit &a = expected.hits[pixel], &b = found.hits[pixel];
        if (tolerance_.isIeee || a.fetches != b.fetches) return false;
        return a.primitive == b.primitive ? allChannels(channels, &a, &b, isClose)
                                          : areTied(expected.rays[pixel], a, b);
    };
    compareRecords(expected.hits, found.hits, width_, channels, isAllowed, row);
}

void PathComparison::compareDirectVisibility(const PathBuffers& expected, const PathBuffers& found,
                                             CheckRow& row) const {
    const Channels channels = surfacePointChannels();
    const auto isAllowed = [&](size_t pixel) {
        const SurfacePoint &a = expected.next[pixel], &b = found.next[pixel];
        return a.primitive == b.primitive
                   ? !tolerance_.isIeee && allChannels(channels, &a, &b, isClose)
                   : tolerance_.mayConfuse(pixel, a.primitive, b.primitive);
    };
    compareRecords(expected.next, found.next, width_, channels, isAllowed, row);
}

void PathComparison::compare(PathBuffer buffer, const PathBuffers& expected,
                             const PathBuffers& found, CheckRow& row) const {
    const auto records = [&](const auto& a, const auto& b, const Channels& channels) {
        const auto isAllowed = [&](size_t pixel) {
            return !tolerance_.isIeee && allChannels(channels, &a[pixel], &b[pixel], isClose);
        };
        compareRecords(a, b, width_, channels, isAllowed, row);
    };
    switch (buffer) {
    case PathBuffer::previous:
        return records(expected.previous, found.previous, surfacePointChannels());
    case PathBuffer::current:
        return records(expected.current, found.current, surfacePointChannels());
    case PathBuffer::next:
        return records(expected.next, found.next, surfacePointChannels());
    case PathBuffer::mask:
        return records(words(expected.mask), words(found.mask), flagChannels("alive", ""));
    case PathBuffer::rays:
        return records(expected.rays, found.rays, rayChannels());
    case PathBuffer::hits:
        return compareHits(expected, found, row);
    case PathBuffer::visibility:
        return records(words(expected.visibility), words(found.visibility),
                       flagChannels("visible", ""));
    case PathBuffer::radiance:
        return records(expected.radiance, found.radiance, radianceChannels());
    case PathBuffer::image:
        return records(expected.image, found.image, radianceChannels());
    }
}

} // namespace dirt
