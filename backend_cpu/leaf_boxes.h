#pragma once

#include "backend_cpu/leaves.h"

#include <span>

#include <glm/vec3.hpp>

namespace dirt {

/// A triangle of a cell's list and a box that holds its part in the cell.
struct LeafItem {
    glm::vec3 low, high;
    uint32_t id;
};

/// Box of the points of one cell that a ray may be found to hit there: those of the tile's cone
/// widened by 1/512 at the depths of the bin.
LeafItem boxOfCell(const Grid& grid, int view, int tile, int bin);

/// Box of the part of a triangle inside the box of a cell.
LeafItem boxOfPart(const Triangle& triangle, uint32_t id, const LeafItem& cell);

/// The axis along which the middles of the boxes spread widest.
int widestAxis(std::span<const LeafItem> items);

/// Boxes of a node's children, as they are gathered and then rounded to the node's steps.
class NodeBoxes {
public:
    void add(std::span<const LeafItem> items);
    void write(LeafNode& node) const;

private:
    glm::vec3 low_[LeafNode::kChildren], high_[LeafNode::kChildren];
    int count_ = 0;
};

} // namespace dirt
