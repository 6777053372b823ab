#include "core/check/check.h"

#include "core/check/check_construction.h"
#include "core/check/check_paths.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace dirt {
namespace {

/// Mean radiance of the pixels in which \p a and \p b see the same surface.
glm::dvec3 meanOf(const SampleCheck& check, const SampleCheck& a, const SampleCheck& b) {
    glm::dvec3 sum(0.0);
    size_t count = 0;
    for (size_t i = 0; i < check.radiance.size(); ++i) {
        if (a.surfaces[i] != b.surfaces[i]) continue;
        sum += glm::dvec3(check.radiance[i]);
        ++count;
    }
    return count > 0 ? sum / (double) count : sum;
}

bool nothingDiffers(const std::vector<CheckRow>& rows) {
    return std::all_of(rows.begin(), rows.end(),
                       [](const CheckRow& row) { return row.different == 0; });
}

} // namespace

bool CheckReport::passed() const {
    const auto [a, b] = means;
    for (int i = 0; i < 3; ++i) {
        const double allowed = kMeanTolerance * std::max({a.x, a.y, a.z, b.x, b.y, b.z});
        if (!(std::abs(a[i] - b[i]) <= allowed)) return false; // NaN neither
    }
    return nothingDiffers(rows);
}

std::vector<CheckRow> checkConstruction(const Mesh& mesh, const Camera& camera,
                                        const GridSettings& settings, Backend& first,
                                        Backend& second) {
    const BuiltStructure a = buildOn(first, mesh, camera, settings);
    const BuiltStructure b = buildOn(second, mesh, camera, settings);
    return checkConstruction(a, b, camera, first, second);
}

CheckReport checkBackends(const Scene& scene, const RenderSettings& settings, Backend& first,
                          Backend& second) {
    BuiltStructure a = buildOn(first, scene.mesh, scene.camera, settings.grid);
    BuiltStructure b = buildOn(second, scene.mesh, scene.camera, settings.grid);
    CheckReport report;
    report.rows = checkConstruction(a, b, scene.camera, first, second);
    // What a ray finds in a wrong structure depends on the order in which cells are visited, which
    // is each backend's own.
    if (!nothingDiffers(report.rows)) a = b = defined(scene.mesh, scene.camera, settings.grid);
    const bool cutOuts = requirementsOf(scene, settings, first.rasterizes()).cutOuts;
    a.geometry.cutOuts = b.geometry.cutOuts = cutOuts ? &scene : nullptr;
    SampleCheck onFirst = checkPaths(scene, settings, a, first, second);
    SampleCheck onSecond = checkPaths(scene, settings, b, second, first);
    report.means = {meanOf(onFirst, onFirst, onSecond), meanOf(onSecond, onFirst, onSecond)};
    for (SampleCheck* check : {&onFirst, &onSecond})
        std::move(check->rows.begin(), check->rows.end(), std::back_inserter(report.rows));
    return report;
}

} // namespace dirt
