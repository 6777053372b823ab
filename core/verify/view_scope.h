#pragma once

#include "core/grid/view.h"
#include "core/trace/ray.h"
#include "core/verify/judge.h"

#include <optional>
#include <utility>

namespace dirt {

/// Which rays a view answers for. In full view all. In single view, by design, a ray that leaves
/// the view returns nothing, and what one that starts outside returns is not defined; so only
/// rays count whose origin lies in the closed view and whose exact hit, if any, does too. A view
/// is convex: such a ray runs inside the view up to its hit. Membership is decided exactly; hits
/// within err(t) of the border, where ViewCone ends rays, do not count.
class ViewScope {
public:
    ViewScope(const GridSettings& settings, const Camera& camera);
    /// Of a single view; none: of full view.
    explicit ViewScope(std::optional<View> view) : view_(std::move(view)) {}

    /// \p truth: the verdict of \p judge's geometry on \p ray.
    bool counts(const Ray& ray, const Verdict& truth, const FrameGeometry& geometry) const;

private:
    std::optional<View> view_;
};

} // namespace dirt
