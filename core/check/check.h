#pragma once

#include "core/check/check_row.h"
#include "core/frame/backend.h"

#include <array>
#include <vector>

#include <glm/vec3.hpp>

namespace dirt {

/// What a check has found.
struct CheckReport {
    std::vector<CheckRow> rows;
    /// Mean radiance of the sample as each backend renders it on its own, over the pixels in which
    /// both see the same surface first.
    std::array<glm::dvec3, 2> means{};

    /// Whether nothing differs that must not, and the means are kMeanTolerance apart at most.
    bool passed() const;
};

/// Of the mean's largest component. The means hold the pixels in which all bits should be equal;
/// this is what a frame may be off where arithmetic is not IEEE and single paths part.
inline constexpr double kMeanTolerance = 1e-4;

/// Builds the structure of \p mesh on two backends and compares every buffer. Each pass of each
/// backend runs on the other's data, so that one fault does not hide the next. Of backends without
/// a grid only the triangle buffer is compared.
///
/// Everything has to be equal. Only where one of the backends is not isIeee() depths may be off by
/// 16 ulp (G2), and lists by the entries in bins whose border is that near to an end of the
/// triangle's depths in that tile.
std::vector<CheckRow> checkConstruction(const Mesh& mesh, const Camera& camera,
                                        const GridSettings& settings, Backend& first,
                                        Backend& second);

/// The same, and then all passes of one sample: each backend renders it once, and the other runs
/// every pass beside it, on a copy of what the first has made so far. Where the structures differ
/// the samples run over core's own, so that the fault of one pass does not show in others. What may
/// differ is said in docs/check.md.
CheckReport checkBackends(const Scene& scene, const RenderSettings& settings, Backend& first,
                          Backend& second);

} // namespace dirt
