#include "core/frame/point_buffer.h"

namespace dirt {

namespace {

/// From primitive to roughness.
constexpr uint32_t kWordsOfAll = PackedPoints::kLeastBytes / sizeof(uint32_t);

} // namespace

PointFormat pointFormatOf(const Requirements& need) {
    PointFormat format;
    if (!need.packedShading) return format;
    format.words = kWordsOfAll;
    if (need.hasShadingNormals()) format.normal = format.words++;
    if (need.emission) format.emission = format.words++;
    if (need.gloss) format.gloss = format.words++;
    return format;
}

PackedPoints::PackedPoints(const PointFormat& format, size_t pixels)
    : format_(format), words_(pixels * format.words, 0) {
    for (size_t pixel = 0; pixel < pixels; ++pixel) set(pixel, {});
}

PackedPoints PackedPoints::only(size_t pixel) const {
    if (empty()) return {};
    const auto first = words_.begin() + (std::ptrdiff_t)(pixel * format_.words);
    return {format_, std::vector<uint32_t>(first, first + (std::ptrdiff_t) format_.words)};
}

PackedPoint PackedPoints::operator[](size_t pixel) const {
    const uint32_t* const words = words_.data() + pixel * format_.words;
    PackedPoint point;
    point.primitive = words[0];
    point.u = words[1];
    point.v = words[2];
    point.diffuse = words[3];
    point.roughness = words[4];
    if (format_.normal) point.normal = words[format_.normal];
    if (format_.emission) point.emission = words[format_.emission];
    if (format_.gloss) point.gloss = words[format_.gloss];
    return point;
}

void PackedPoints::set(size_t pixel, const PackedPoint& point) {
    uint32_t* const words = words_.data() + pixel * format_.words;
    words[0] = point.primitive;
    words[1] = point.u;
    words[2] = point.v;
    words[3] = point.diffuse;
    words[4] = point.roughness;
    if (format_.normal) words[format_.normal] = point.normal;
    if (format_.emission) words[format_.emission] = point.emission;
    if (format_.gloss) words[format_.gloss] = point.gloss;
}

PackedPoint packPoint(const SurfacePoint& point, const FrameGeometry& geometry) {
    if (!point.found()) return {};
    const Triangle& triangle = geometry.triangles[point.primitive];
    return packPoint(point, triangle.a, triangle.b, triangle.c);
}

SurfacePoint unpackPoint(const PackedPoint& packed, const FrameGeometry& geometry) {
    if (packed.primitive == kNoPrimitive) return {};
    const Triangle& triangle = geometry.triangles[packed.primitive];
    return unpackPoint(packed, triangle.a, triangle.b, triangle.c);
}

std::vector<SurfacePoint> unpack(const PackedPoints& points, const FrameGeometry& geometry) {
    std::vector<SurfacePoint> unpacked(points.size());
    for (size_t pixel = 0; pixel < unpacked.size(); ++pixel)
        unpacked[pixel] = unpackPoint(points[pixel], geometry);
    return unpacked;
}

PackedPoints pack(const std::vector<SurfacePoint>& points, const PointFormat& format,
                  const FrameGeometry& geometry) {
    PackedPoints packed(format, points.size());
    for (size_t pixel = 0; pixel < points.size(); ++pixel)
        packed.set(pixel, packPoint(points[pixel], geometry));
    return packed;
}

} // namespace dirt
