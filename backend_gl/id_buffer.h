#pragma once

#include "backend_gl/depth_bounds.h"

#include <cstdint>
#include <vector>

namespace dirt {

/// How much room FillPrimitives asks for.
struct ListCounts {
    uint64_t entries = 0; ///< in all lists
    uint32_t pairs = 0;   ///< of a triangle and a tile that lists it
};

/// The id buffer on the device: a linked list of (next, primitive) nodes for every (view, tile,
/// bin). The heads lie in a texture, the nodes in a pool of at most kMostSegments buffers, whose
/// size is learnt: what does not fit is counted, and the pass run again over a larger pool (G4).
class IdBuffer {
public:
    /// \p nodes: of the first pool. \p segmentBits: nodes of a segment; 0: as many as the driver
    /// allows.
    IdBuffer(Programs& programs, uint32_t nodes, int segmentBits);

    /// Whether the driver has a texture for the heads of that many lists.
    static bool fits(int columns, int rows, int lists);

    /// Empty lists for \p grid.
    void clear(const Grid& grid);

    /// FillPrimitives. False, with nothing usable in the lists, where the pool cannot become as
    /// large as counts() then says.
    [[nodiscard]] bool fill(const TriangleBuffer& triangles, const DepthBoundsTexture& bounds,
                            ViewMode mode, Proposal proposal);

    void read(Grid& grid) const;
    void write(const Grid& grid);

    /// Binds the pool as storage blocks 0 … segments() − 1.
    void bindNodes() const;
    GLuint heads() const { return heads_.id(); }
    /// That the pool has: shaders go through all of them for each node.
    int segments() const { return (int) segments_.size(); }
    int segmentBits() const { return segmentBits_; }

    const ListCounts& counts() const { return counts_; }
    /// The largest pool that the driver allows, in nodes.
    uint64_t mostNodes() const { return mostNodes_; }
    uint64_t headBytes() const;
    uint64_t nodeBytes() const { return (uint64_t) capacity_ * sizeof(Node); }
    static uint64_t usedBytes(uint64_t entries) { return entries * sizeof(Node); }

private:
    struct Node {
        uint32_t next, primitive;
    };
    void clearHeads() const;
    void setCapacity(uint64_t nodes);
    void count(const TriangleBuffer& triangles, ViewMode mode, Proposal proposal);

    Programs& programs_;
    int segmentBits_;
    int segmentLimit_;
    uint64_t mostNodes_;
    uint32_t capacity_ = 0;
    ListCounts counts_;
    std::vector<GlBuffer> segments_;
    GlTexture heads_;
    GlBuffer counters_;
    GlTexture counterView_;
    GlFramebuffer framebuffer_; ///< without pictures, as large as the views
    int columns_ = 0, rows_ = 0, views_ = 0, bins_ = 0;
};

} // namespace dirt
