#pragma once

#include "core/base/executor.h"

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace dirt {

/// Where in the buffers something is. What has no meaning for a fault is empty; of two faults the
/// one that is less comes first.
struct ReplayPlace {
    std::optional<uint32_t> view, level, tile, bin; ///< tile: row-major, at the level
    std::optional<uint32_t> pixel, primitive;
    auto operator<=>(const ReplayPlace&) const = default;
};

/// What a judge has found of a buffer that a pass wrote.
struct JudgedPass {
    std::string pass;   ///< as the paper names it
    int event = -1;     ///< path event; -1: of the construction
    std::string buffer; ///< "depth bounds", "lists", …

    uint64_t compared = 0, right = 0;
    /// Wrong, as a right pass would be on what it was given: the fault is an earlier pass's.
    uint64_t inherited = 0;
    /// Not judged: rays that a single view does not answer for.
    uint64_t outside = 0;
    /// Sorts of faults, with how many there are.
    std::vector<std::pair<std::string, uint64_t>> faults;
    double largestTError = 0.0; ///< of right hits, in units in the last place

    ReplayPlace place; ///< of the first fault in the order of places; where wrong() is not 0
    std::string first; ///< the same in words

    uint64_t wrong() const;
    /// Counts \p count faults of a sort; \p words(), called if it is the first, say what is wrong.
    template <typename Words>
    void fault(const std::string& sort, const ReplayPlace& at, const Words& words) {
        const bool isFirst = wrong() == 0 || at < place;
        ++countOf(sort);
        if (!isFirst) return;
        place = at;
        first = words();
    }
    /// Adds what another has found of the same buffer.
    void add(const JudgedPass& other);
    /// Adds what \p judge finds in pieces of [0, \p count) of at most \p grain, in their order
    /// whatever the number of threads.
    void addPieces(Executor& executor, size_t count, size_t grain,
                   const std::function<JudgedPass(size_t begin, size_t end)>& judge);
    /// "Trace 1", or the name alone.
    std::string name() const;

private:
    uint64_t& countOf(const std::string& sort);
};

/// The first pass of \p passes, which are in the order of a frame, that is wrong; null: none is.
const JudgedPass* firstWrong(const std::vector<JudgedPass>& passes);

} // namespace dirt
