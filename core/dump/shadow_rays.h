#pragma once

#include "core/frame/passes.h"

#include <cstdint>
#include <span>
#include <vector>

namespace dirt {

/// The shadow ray of one pixel as it is dumped: what was asked, what Visibility answered, and what
/// is in between.
struct ShadowRecord {
    glm::vec3 origin{0.0f};       ///< grid frame
    uint32_t skip = kNoPrimitive; ///< primitive it starts on and does not hit
    glm::vec3 direction{0.0f};    ///< grid frame; zero: none was cast
    float tMax = 0.0f;            ///< what is hit before blocks it; in units of the direction
    uint32_t occluded = 0;        ///< 1: Visibility found it blocked
    uint32_t blocker = kNoPrimitive;
    float t = 0.0f;      ///< of the blocker
    uint32_t view = 0;   ///< of the tile in which the blocker was hit; the number of
    uint32_t column = 0; ///< views where only the eye itself is, or without a grid 0
    uint32_t row = 0;
};
static_assert(sizeof(ShadowRecord) == 56);

/// A shadow ray and its answer; its blocker is not looked for.
ShadowRecord shadowRecordOf(const ShadowRay& shadow, bool occluded);

/// Adds the blockers to \p records: what \p backend finds as the nearest hits of their rays before
/// tMax. \p views: of its structure.
void findBlockers(Backend& backend, const std::vector<View>& views,
                  std::span<ShadowRecord> records);

/// The shadow rays of path event \p event, one a pixel; empty where the frame casts none. The
/// answers are those that \p paths has. A search for any hit keeps no record of what it found, so
/// \p backend is asked for the nearest hit of the same rays: the blocker is what that finds before
/// tMax, whatever the answer is.
std::vector<ShadowRecord> shadowRecordsOf(const FrameContext& frame, Backend& backend, int event,
                                          const PathBuffers& paths);

} // namespace dirt
