#pragma once

#include "core/grid/geometry.h"
#include "core/trace/ray.h"
#include "core/verify/box_tree.h"

#include <cstdint>
#include <span>
#include <vector>

namespace dirt {

/// The truth about one ray.
struct Verdict {
    /// The primitives hit at the exact nearest t, in increasing order; empty where none is hit.
    std::vector<uint32_t> primitives;
    double t = 0.0; ///< that t; relative error below 2^-50

    bool found() const { return !primitives.empty(); }
};

/// How an answer compares with the truth.
enum class Grade {
    right,
    missed,   ///< there is a hit, and none was given
    falseHit, ///< there is no hit, and one was given
    /// The given primitive is not hit, or another is nearer by more than err(t); not where both
    /// are so near or so far, in units of the direction, that t leaves float's range.
    wrongPrimitive
};

struct Judgement {
    Grade grade = Grade::right;
    /// |t given - exact t| / exact t of the given primitive, where that is hit; else 0.
    double relativeTError = 0.0;
    double ulpTError = 0.0; ///< the same in units in the last place
};

/// Decides by exact arithmetic what rays hit. It shares no code with core/trace, which it judges:
/// its own box tree proposes triangles, a double-precision filter with a derived bound sorts out
/// most, and what is left is decided with big integers. Safe to use from several threads.
///
/// A ray that starts on a primitive (Ray::skip) hits neither that nor any with the same vertices.
/// A ray with a NaN or an infinity, or without direction, hits nothing. Where the geometry has
/// holes, they are looked up by the barycentric weights of core's test.
class Judge {
public:
    /// \p geometry must outlive the judge and stay unchanged.
    explicit Judge(const FrameGeometry& geometry);

    Verdict nearest(const Ray& ray) const;
    /// The same without the box tree: every triangle goes through the filter.
    Verdict nearestOfAll(const Ray& ray) const;

    /// Compares \p hit with \p truth, the verdict on the same ray.
    Judgement judge(const Ray& ray, const Verdict& truth, const Hit& hit) const;

private:
    bool skipped(const Ray& ray, uint32_t primitive) const;
    bool inHole(const Ray& ray, uint32_t primitive) const;
    Verdict decide(const Ray& ray, std::span<const uint32_t> candidates) const;

    const FrameGeometry& geometry_;
    BoxTree boxes_;
    std::vector<uint32_t> all_; ///< every primitive id
};

} // namespace dirt
