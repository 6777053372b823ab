#pragma once

#include "core/base/executor.h"
#include "core/grid/geometry.h"

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

namespace dirt {

struct LightCone;

/// Where things lie on a face is said in places: of 2^24 along it, counted from the rim.
inline constexpr int kPlaceBits = 24;
inline constexpr double kPlacesPerSlope = 1 << (kPlaceBits - 1);

/// Boxes in a tile have so many bits a bound; so a tile is as many places wide at least.
inline constexpr int kUnitBits = 7;

/// A face of the cube around the light, and the tree's roots on it that the light's cone may reach.
struct LightFace {
    int axisX, axisY, axisW; ///< components of the grid frame
    float signW;
    int column = 0, row = 0; ///< the first
    int columns = 0, rows = 0;
    uint32_t firstNode = 0; ///< in the numbering over all faces
};

/// The tiles of a light grid: small where the light sees many triangles. Each face is cut into
/// equal squares, the roots, and those that many triangles lie in are cut into 4 by 4, and so on.
struct LightTree {
    static constexpr uint32_t kInner = 1u << 31;
    static constexpr int kSplitBits = 2; ///< a node's children stand 4 by 4, row by row

    std::array<LightFace, 6> faces;
    int rootShift = kPlaceBits; ///< a root is 2^rootShift places wide
    uint32_t tiles = 0;
    /// The roots of all faces, then the children of inner nodes. A tile's number, those of one root
    /// following one another, or kInner and the first child's index.
    std::vector<uint32_t> nodes;
};

/// Makes the tiles for what \p geometry shows to a light at \p position, by a part of its
/// triangles. The same tree for any number of threads.
void makeLightTree(const FrameGeometry& geometry, const glm::vec3& position, const LightCone& cone,
                   Executor& executor, LightTree& tree);

} // namespace dirt
