#include "backend_gl/id_buffer.h"

#include "core/base/error.h"

#include <algorithm>
#include <bit>

namespace dirt {
namespace {

constexpr uint32_t kNoNode = 0xffffffffu; // include/nodes.glsl

/// A segment needs to be no larger than this.
constexpr GLint64 kLargestSegment = 1 << 30;

GLint64 limit(GLenum name) {
    GLint64 value = 0;
    glGetInteger64v(name, &value);
    return value;
}

} // namespace

IdBuffer::IdBuffer(Programs& programs, uint32_t nodes, int segmentBits)
    : programs_(programs), segmentBits_(segmentBits), counters_(3 * sizeof(uint32_t)),
      counterView_(makeTexture(GL_TEXTURE_BUFFER)), framebuffer_(makeFramebuffer()) {
    if (segmentBits_ == 0) {
        const GLint64 bytes = std::min(limit(GL_MAX_SHADER_STORAGE_BLOCK_SIZE), kLargestSegment);
        segmentBits_ = (int) std::bit_width((uint64_t) bytes / sizeof(Node)) - 1;
    }
    // Tracing needs three more blocks: rays, hits and states.
    segmentLimit_ =
        (int) std::min<GLint64>({limit(GL_MAX_FRAGMENT_SHADER_STORAGE_BLOCKS),
                                 limit(GL_MAX_COMPUTE_SHADER_STORAGE_BLOCKS) - 3, kMostSegments});
    mostNodes_ = std::min((uint64_t) segmentLimit_ << segmentBits_, (uint64_t) kNoNode);
    glTextureBuffer(counterView_.id(), GL_R32UI, counters_.id());
    setCapacity(nodes);
}

bool IdBuffer::fits(int columns, int rows, int lists) {
    return textureFits(1, GL_R32UI, columns, rows, lists);
}

void IdBuffer::clear(const Grid& grid) {
    const int columns = grid.views[0].columns, rows = grid.views[0].rows;
    const int views = (int) grid.views.size(), bins = grid.settings.bins;
    if (!heads_.id() || columns != columns_ || rows != rows_ || views != views_ || bins != bins_) {
        columns_ = columns;
        rows_ = rows;
        views_ = views;
        bins_ = bins;
        heads_ = {}; // before the next ones are allocated
        heads_ = makeTexture(GL_TEXTURE_2D_ARRAY);
        glTextureStorage3D(heads_.id(), 1, GL_R32UI, columns_, rows_, views_ * bins_);
        glTextureParameteri(heads_.id(), GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTextureParameteri(heads_.id(), GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        glNamedFramebufferParameteri(framebuffer_.id(), GL_FRAMEBUFFER_DEFAULT_WIDTH, columns_);
        glNamedFramebufferParameteri(framebuffer_.id(), GL_FRAMEBUFFER_DEFAULT_HEIGHT, rows_);
        glNamedFramebufferParameteri(framebuffer_.id(), GL_FRAMEBUFFER_DEFAULT_LAYERS, views_);
    }
    clearHeads();
    counts_ = {};
}

void IdBuffer::clearHeads() const {
    glClearTexImage(heads_.id(), 0, GL_RED_INTEGER, GL_UNSIGNED_INT, &kNoNode);
}

void IdBuffer::setCapacity(uint64_t nodes) {
    capacity_ = (uint32_t) std::min(nodes, mostNodes_);
    segments_.clear();
    const uint64_t full = 1ull << segmentBits_;
    for (uint64_t first = 0; first < capacity_; first += full)
        segments_.emplace_back(std::min(full, capacity_ - first) * sizeof(Node));
}

/// Runs the pass over the pool as it is, and sets counts_.
void IdBuffer::count(const TriangleBuffer& triangles, ViewMode mode, Proposal proposal) {
    const uint32_t zero[3] = {};
    counters_.write(0, sizeof zero, zero);
    programs_.use(fillPrimitivesSource(mode, proposal, segments(), segmentBits_));
    glUniform1ui(0, capacity_);
    bindNodes();
    triangles.draw();
    glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT |
                    GL_BUFFER_UPDATE_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT);
    uint32_t counted[3] = {};
    counters_.read(0, sizeof counted, counted);
    counts_ = {(uint64_t) counted[1] << 32 | counted[0], counted[2]};
}

bool IdBuffer::fill(const TriangleBuffer& triangles, const DepthBoundsTexture& bounds,
                    ViewMode mode, Proposal proposal) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    glViewport(0, 0, columns_, rows_);
    glBindTextureUnit(2, bounds.texture());
    glBindImageTexture(0, heads_.id(), 0, GL_TRUE, 0, GL_READ_WRITE, GL_R32UI);
    glBindImageTexture(1, counterView_.id(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_R32UI);
    count(triangles, mode, proposal);
    if (counts_.entries > capacity_ && counts_.entries <= mostNodes_) {
        // An eighth more, so that what moves a little fits the next time.
        setCapacity(counts_.entries + counts_.entries / 8);
        clearHeads();
        count(triangles, mode, proposal);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    return counts_.entries <= capacity_;
}

void IdBuffer::read(Grid& grid) const {
    const size_t cellsOfLayer = (size_t) columns_ * (size_t) rows_;
    std::vector<uint32_t> heads(cellsOfLayer * (size_t) (views_ * bins_));
    glGetTextureImage(heads_.id(), 0, GL_RED_INTEGER, GL_UNSIGNED_INT,
                      (GLsizei) std::min<size_t>(heads.size() * sizeof(uint32_t), INT32_MAX),
                      heads.data());
    std::vector<Node> nodes(counts_.entries);
    for (size_t i = 0, first = 0; first < nodes.size(); ++i, first += 1ull << segmentBits_)
        segments_[i].read(
            0, std::min<size_t>(1ull << segmentBits_, nodes.size() - first) * sizeof(Node),
            nodes.data() + first);

    grid.heads.clear();
    grid.heads.reserve(heads.size() + 1);
    grid.ids.clear();
    grid.ids.reserve(nodes.size());
    for (int view = 0; view < views_; ++view)
        for (size_t tile = 0; tile < cellsOfLayer; ++tile)
            for (int bin = 0; bin < bins_; ++bin) {
                const size_t first = grid.ids.size();
                grid.heads.push_back((uint32_t) first);
                const size_t layer = (size_t) view * (size_t) bins_ + (size_t) bin;
                for (uint32_t node = heads[layer * cellsOfLayer + tile]; node != kNoNode;
                     node = nodes[node].next)
                    grid.ids.push_back(nodes[node].primitive);
                std::sort(grid.ids.begin() + (ptrdiff_t) first, grid.ids.end());
            }
    grid.heads.push_back((uint32_t) grid.ids.size());
}

void IdBuffer::write(const Grid& grid) {
    counts_ = {grid.ids.size(), 0};
    if (grid.heads.empty()) return; // not filled yet
    if (grid.ids.size() > mostNodes_)
        throw InputError("these lists are longer than this OpenGL driver allows");
    if (grid.ids.size() > capacity_) setCapacity(grid.ids.size());
    const size_t cellsOfLayer = (size_t) columns_ * (size_t) rows_;
    std::vector<uint32_t> heads(cellsOfLayer * (size_t) (views_ * bins_), kNoNode);
    std::vector<Node> nodes(grid.ids.size());
    for (size_t cell = 0; cell + 1 < grid.heads.size(); ++cell) {
        const uint32_t first = grid.heads[cell], end = grid.heads[cell + 1];
        for (uint32_t i = first; i < end; ++i)
            nodes[i] = {i + 1 < end ? i + 1 : kNoNode, grid.ids[i]};
        const size_t bin = cell % (size_t) bins_, tile = cell / (size_t) bins_;
        const size_t layer = tile / cellsOfLayer * (size_t) bins_ + bin;
        if (first < end) heads[layer * cellsOfLayer + tile % cellsOfLayer] = first;
    }
    glTextureSubImage3D(heads_.id(), 0, 0, 0, 0, columns_, rows_, views_ * bins_, GL_RED_INTEGER,
                        GL_UNSIGNED_INT, heads.data());
    for (size_t i = 0, first = 0; first < nodes.size(); ++i, first += 1ull << segmentBits_)
        segments_[i].write(
            0, std::min<size_t>(1ull << segmentBits_, nodes.size() - first) * sizeof(Node),
            nodes.data() + first);
}

void IdBuffer::bindNodes() const {
    for (int i = 0; i < segments(); ++i)
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, (GLuint) i, segments_[(size_t) i].id());
}

uint64_t IdBuffer::headBytes() const {
    return (uint64_t) columns_ * (uint64_t) rows_ * (uint64_t) (views_ * bins_) * sizeof(uint32_t);
}

} // namespace dirt
