#include "app/cli/memory_limit.h"

#include "backend_cpu/memory_forecast.h"
#include "core/base/error.h"
#include "core/frame/memory_plan.h"
#include "core/frame/path_buffers.h"
#include "core/frame/requirements.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <string>

#include <unistd.h>

namespace dirt {

namespace {

/// What every frame has, whatever the scene requires besides: an estimate from below.
constexpr uint64_t kBytesPerPixel = PackedPoints::kLeastBytes + 2 * sizeof(glm::vec3);
/// Depth bounds, and a third more for the pyramid.
constexpr uint64_t kBytesPerTile = 11;
/// One head of a list.
constexpr uint64_t kBytesPerCell = 4;

uint64_t structureBytes(const GridSettings& s, int tile) {
    const auto tiles = [tile](int pixels) { return (uint64_t) (pixels + tile - 1) / tile; };
    const int face = s.viewSize > 0 ? s.viewSize : s.height;
    const uint64_t count =
        s.mode == ViewMode::full ? 6 * tiles(face) * tiles(face) : tiles(s.width) * tiles(s.height);
    return count * (kBytesPerTile + (uint64_t) s.bins * kBytesPerCell);
}

/// A frame of a backend: all, and what of it is the structure's.
struct Need {
    uint64_t all = 0, structure = 0;
};

/// Of the CPU the forecast; of OpenGL what is planned, with the lists' pools and the textures'
/// copies; Embree's trees have up to 200 bytes a triangle.
Need needOf(BackendKind kind, const Scene& scene, const RenderSettings& settings,
            const std::optional<Footprint>& footprint) {
    const uint64_t triangles = scene.mesh.triangles.size();
    const Requirements need = requirementsOf(scene, settings, kind != BackendKind::embree);
    if (kind == BackendKind::cpu) {
        const MemoryForecast forecast = forecastMemory(*footprint, triangles, settings, need);
        return {forecast.total(), forecast.structure};
    }
    Need sum;
    for (const PlannedBuffer& buffer : planPaths(need, settings.grid)) sum.all += buffer.bytes;
    if (kind == BackendKind::embree) {
        sum.all += triangles * (sizeof(Triangle) + 200);
        return sum;
    }
    const uint64_t entries = 4 * triangles;
    for (const PlannedBuffer& buffer :
         planStructure(settings.grid, scene.camera, triangles, entries))
        sum.structure += buffer.bytes;
    for (const Texture& texture : scene.textures) sum.all += texture.bytes();
    for (const ScalarTexture& texture : scene.scalarTextures) sum.all += texture.bytes();
    sum.all += sum.structure;
    return sum;
}

Need needOf(const Scene& scene, const RenderSettings& settings,
            const std::optional<Footprint>& footprint, const CommonOptions& options) {
    Need sum;
    const auto add = [&](BackendKind kind) {
        const Need one = needOf(kind, scene, settings, footprint);
        sum.all += one.all;
        sum.structure += one.structure;
    };
    if (options.backends.empty()) add(options.backend);
    for (const BackendKind kind : options.backends) add(kind);
    return sum;
}

} // namespace

uint64_t sceneMemory(const CommonOptions& options) {
    return options.memory.value_or(availableMemory() / 2);
}

uint64_t checkFrameMemory(const Scene& scene, const RenderSettings& settings,
                          const std::optional<Footprint>& footprint, const CommonOptions& options,
                          const MemoryBudget& budget) {
    const Need need = needOf(scene, settings, footprint, options);
    const uint64_t left = budget.left();
    if (need.all <= left) return need.all;
    std::string text = "a frame needs about " + memoryText(need.all) + " of memory; " +
                       memoryText(left) + " of " + memoryText(budget.limit()) + " are left";
    if (need.structure > need.all / 2) {
        text += ": --tile " + std::to_string(settings.grid.tile) + " --bins " +
                std::to_string(settings.grid.bins) + " take " + memoryText(need.structure);
        RenderSettings other = settings;
        while (other.grid.tile < 64 && needOf(scene, other, footprint, options).all > left)
            other.grid.tile = std::min(64, 2 * other.grid.tile);
        if (needOf(scene, other, footprint, options).all <= left)
            text += " (--tile " + std::to_string(other.grid.tile) + " would fit)";
    }
    throw MemoryError(options.scene + ": " + text);
}

uint64_t availableMemory() {
    uint64_t bytes = std::numeric_limits<uint64_t>::max();
    const long pages = sysconf(_SC_PHYS_PAGES), page = sysconf(_SC_PAGE_SIZE);
    if (pages > 0 && page > 0) bytes = (uint64_t) pages * (uint64_t) page;
    uint64_t limit = 0;
    if (std::ifstream("/sys/fs/cgroup/memory.max") >> limit) bytes = std::min(bytes, limit);
    return bytes;
}

void checkMemory(const GridSettings& s, uint64_t available) {
    const uint64_t image = (uint64_t) s.width * (uint64_t) s.height * kBytesPerPixel;
    if (image > available)
        throw InputError("an image of " + std::to_string(s.width) + "x" + std::to_string(s.height) +
                         " pixels needs more than " + memoryText(image) +
                         " of memory; a scene may take " + memoryText(available) + " (--memory)");

    const uint64_t structure = structureBytes(s, s.tile);
    if (image + structure <= available) return;
    int fits = s.tile;
    while (fits < 64 && image + structureBytes(s, fits) > available / 2) ++fits;
    throw InputError("--tile " + std::to_string(s.tile) + " --bins " + std::to_string(s.bins) +
                     ": the structure needs more than " + memoryText(structure) +
                     " of memory; a scene may take " + memoryText(available) + " (--tile " +
                     std::to_string(fits) + " would fit)");
}

} // namespace dirt
