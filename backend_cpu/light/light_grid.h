#pragma once

#include "backend_cpu/build/fragments.h"
#include "backend_cpu/light/light_tree.h"
#include "core/base/executor.h"
#include "core/grid/geometry.h"
#include "core/scene/light.h"

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

namespace dirt {

/// Planes of a triangle as the light sees it. Lanes 0 to 2 are the planes through the light and an
/// edge, positive inside; lane 3 is the triangle's own, less `offset`, positive beyond it. At p, a
/// point seen from the light, lane k is x[k] p.x + y[k] p.y + z[k] p.z.
struct alignas(64) LightRecord {
    float x[4], y[4], z[4];
    float offset;
    float margin; ///< per |p|: nearer to zero a lane decides nothing
    uint32_t unused[2] = {};
};
static_assert(sizeof(LightRecord) == 64);

/// A triangle's part in one tile, none of it nearer to the light than `near`. Where it lies in the
/// tile, in 128ths: bytes of the least column, 127 less the greatest, and the same of rows.
struct LightFragment {
    uint32_t tile, id;
    float near;
    uint32_t box;
};

/// What one piece of the triangles gives to a light grid, in the order of ids.
struct LightPiece {
    std::vector<LightFragment> fragments;
    std::vector<uint32_t> close;
};

/// One more view of the frame's geometry: from a spotlight's position. A shadow ray, reversed,
/// starts in that point, so all of it lies in one tile, at one point of it; whatever may occlude it
/// is in one list. docs/grid.md says why nothing is missed.
struct LightGrid {
    /// Lists are read by so many entries at once, also beyond the last.
    static constexpr size_t kPadding = 16;

    glm::vec3 position{0.0f};
    LightTree tree;       ///< without tiles there is no light grid
    float reach = 0.0f;   ///< largest |p| of a ray's origin that the bounds hold for,
    float nearest = 0.0f; ///< and least: nothing listed is nearer to the light

    std::vector<uint32_t> heads; ///< of the tiles' lists, and the end; the lists' entries are
    std::vector<float> near;     ///< those of LightFragment, in the order of ids
    std::vector<uint32_t> box, id;
    std::vector<LightRecord> records; ///< by triangle; of those that are listed
    std::vector<uint32_t> close; ///< triangles that may be nearer than that: any ray may meet them

    // Kept from frame to frame, while the lists are filled.
    std::vector<LightPiece> pieces;
    FragmentBuckets<LightFragment> buckets;

    bool empty() const { return tree.tiles == 0; }
    uint64_t bytes() const;      ///< of what rays read
    uint64_t pieceBytes() const; ///< of the rest
};

/// Fills the light grid of \p light. It stays empty where too much is close to the light. The same
/// bits for any number of threads and on every instruction set.
void fillLightGrid(const FrameGeometry& geometry, const Spotlight& light, Executor& executor,
                   LightGrid& grid);

} // namespace dirt
