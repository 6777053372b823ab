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

} // namespace

void PathBuffers::allocate(const Requirements& need, size_t pixels) {
    make(previous, need.previousPoint, pixels);
    make(current, need.indirect || need.previousPoint, pixels);
    make(next, true, pixels);
    make(mask, need.indirect, pixels);
    make(rays, need.indirect || need.tracedPrimary, pixels);
    make(hits, need.indirect || need.tracedPrimary, pixels);
    make(visibility, need.shadowRays, pixels);
    make(radiance, true, pixels);
    make(image, true, pixels);
}

std::vector<std::pair<std::string, uint64_t>> PathBuffers::sizes() const {
    std::vector<std::pair<std::string, uint64_t>> sizes;
    const auto add = [&sizes](const char* name, const auto& buffer) {
        if (!buffer.empty()) sizes.emplace_back(name, buffer.size() * sizeof(buffer[0]));
    };
    add("shading buffer G[k-1]", previous);
    add("shading buffer G[k]", current);
    add("shading buffer G[k+1]", next);
    add("mask", mask);
    add("rays", rays);
    add("hit buffer", hits);
    add("visibility", visibility);
    add("radiance", radiance);
    add("image", image);
    return sizes;
}

} // namespace dirt
