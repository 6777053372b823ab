#include "core/frame/path_buffers.h"

namespace dirt {

namespace {

template <typename T>
void make(std::vector<T>& buffer, bool wanted, size_t pixels) {
    buffer.clear();
    if (wanted)
        buffer.resize(pixels);
    else
        buffer.shrink_to_fit();
}

void make(PackedPoints& buffer, bool wanted, const PointFormat& format, size_t pixels) {
    buffer = {}; // before the next one is allocated
    if (wanted && format.packed()) buffer = PackedPoints(format, pixels);
}

} // namespace

PathBuffers PathBuffers::only(size_t pixel) const {
    PathBuffers one;
    const auto take = [pixel](const auto& all, auto& record) {
        if (!all.empty()) record.push_back(all[pixel]);
    };
    take(previous, one.previous);
    take(current, one.current);
    take(next, one.next);
    one.packedPrevious = packedPrevious.only(pixel);
    one.packedCurrent = packedCurrent.only(pixel);
    one.packedNext = packedNext.only(pixel);
    take(mask, one.mask);
    take(rays, one.rays);
    take(hits, one.hits);
    take(visibility, one.visibility);
    take(radiance, one.radiance);
    take(image, one.image);
    return one;
}

void PathBuffers::allocate(const Requirements& need, size_t pixels) {
    const PointFormat format = pointFormatOf(need);
    const bool full = !format.packed(), keepsCurrent = need.indirect || need.previousPoint;
    make(previous, full && need.previousPoint, pixels);
    make(current, full && keepsCurrent, pixels);
    make(next, full, pixels);
    make(packedPrevious, need.previousPoint, format, pixels);
    make(packedCurrent, keepsCurrent, format, pixels);
    make(packedNext, true, format, pixels);
    make(mask, need.indirect, pixels);
    make(rays, need.indirect || need.tracedPrimary, pixels);
    make(hits, need.indirect || need.tracedPrimary, pixels);
    make(visibility, need.shadowRays, pixels);
    make(radiance, true, pixels);
    make(image, true, pixels);
}

PathBuffers PathBuffers::unpacked(const FrameGeometry& geometry) const {
    PathBuffers all = *this;
    if (packedNext.empty()) return all;
    all.previous = unpack(packedPrevious, geometry);
    all.current = unpack(packedCurrent, geometry);
    all.next = unpack(packedNext, geometry);
    all.packedPrevious = all.packedCurrent = all.packedNext = {};
    return all;
}

PathBuffers PathBuffers::packed(const PointFormat& format, const FrameGeometry& geometry) const {
    PathBuffers all = *this;
    if (!format.packed()) return all;
    all.packedPrevious = pack(previous, format, geometry);
    all.packedCurrent = pack(current, format, geometry);
    all.packedNext = pack(next, format, geometry);
    all.previous = all.current = all.next = {};
    return all;
}

std::vector<BufferSize> PathBuffers::sizes() const {
    std::vector<BufferSize> sizes;
    const auto add = [&sizes](const char* name, const auto& buffer) {
        if (!buffer.empty()) sizes.emplace_back(name, buffer.size() * sizeof(buffer[0]));
    };
    add("shading buffer G[k-1]", previous);
    add("shading buffer G[k]", current);
    add("shading buffer G[k+1]", next);
    add("shading buffer G[k-1]", packedPrevious.words());
    add("shading buffer G[k]", packedCurrent.words());
    add("shading buffer G[k+1]", packedNext.words());
    add("mask", mask);
    add("rays", rays);
    add("hit buffer", hits);
    add("visibility", visibility);
    add("radiance", radiance);
    add("image", image);
    return sizes;
}

} // namespace dirt
