#pragma once

#include "backend_gl/programs.h"

#include <cstdint>

namespace dirt {

/// How a proposal's lists differ from those that they should be.
struct ProposalFaults {
    uint64_t missed = 0;   ///< entries that the exact test takes where the tile is proposed
    uint64_t repeated = 0; ///< entries that are there already

    bool any() const { return missed > 0 || repeated > 0; }
};

/// Of what \p proposal draws, as the driver rasterizes now, over a few thousand triangles that are
/// hard to rasterize, whose rectangles reach all their tiles.
ProposalFaults proposalFaults(Programs& programs, Proposal proposal);

} // namespace dirt
