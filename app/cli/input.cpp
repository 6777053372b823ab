#include "app/cli/input.h"

#include "app/cli/log.h"
#include "app/cli/memory_limit.h"
#include "app/cli/model_camera.h"
#include "app/cli/option_scope.h"
#include "app/cli/progress_bar.h"
#include "app/cli/thread_limit.h"
#include "backend_cpu/cpu_backend.h"
#include "backend_cpu/thread_pool.h"
#include "core/base/error.h"
#include "core/cost/cost_model.h"
#include "core/frame/auto_camera.h"
#include "core/frame/move_scene.h"
#include "core/io/load.h"
#include "core/path/shadow_frustum.h"

#ifdef DIRT_HAVE_EMBREE
#include "backend_embree/embree_backend.h"
#endif

#ifdef DIRT_HAVE_GL
#include "backend_gl/gl_backend.h"
#endif

#include <algorithm>

namespace dirt {

namespace {

/// Radiance around a bare model.
constexpr float kModelBackground = 0.5f;

/// Names of a kind that are said before every run.
constexpr size_t kNamesShown = 5;

RenderSettings settingsOf(const SceneSettings& file) {
    RenderSettings settings;
    settings.grid.mode = file.view.value_or(settings.grid.mode);
    settings.grid.tile = file.tile.value_or(settings.grid.tile);
    settings.grid.bins = file.bins.value_or(settings.grid.bins);
    settings.bounces = file.bounces.value_or(settings.bounces);
    settings.visibility = file.visibility.value_or(settings.visibility);
    return settings;
}

/// Whether \p file, which could be loaded, is a model alone.
bool isModel(const std::filesystem::path& file) {
    return (file.extension().string()[1] | 0x20) != 's';
}

/// The first of \p names, and how many more there are.
std::string someOf(const std::vector<std::string>& names) {
    std::string text;
    const size_t shown = std::min(names.size(), kNamesShown);
    for (size_t i = 0; i < shown; ++i) text += (i == 0 ? "" : ", ") + names[i];
    if (shown < names.size()) text += " and " + std::to_string(names.size() - shown) + " more";
    return text;
}

void sayAll(const LoadedScene& loaded, bool quiet) {
    for (const Warning& warning : loaded.warnings) sayWarning(warning.text, quiet);
    const bool more = loaded.ignored.size() > kNamesShown;
    if (!loaded.ignored.empty())
        sayNote("ignored: " + someOf(loaded.ignored) + (more ? ", see dirt info" : ""), quiet);
    if (!loaded.caches.empty())
        sayNote("wrote " + someOf(loaded.caches) +
                    ", for faster loading from now on (--no-cache leaves none)",
                quiet);
}

/// Says which options the scene leaves without effect.
void noteIdleOptions(const CommonOptions& options, const Scene& scene) {
    if (options.frame && scene.animation.empty())
        sayWarning("--frame: the scene does not move", options.quiet);
    if (options.visibility && scene.lights.empty() && !isModel(options.scene))
        sayWarning("--visibility: the scene has no light", options.quiet);
    else if (options.visibility && !scene.lights.empty() && !scene.lights.front().shadows)
        sayWarning("--visibility: the light casts no shadows", options.quiet);
}

/// Shows a part of a scene that the file of the scene has a camera for.
void showPart(LoadedScene loaded, const CommonOptions& options, const InputWatch& watch) {
    Input part;
    try {
        part.settings = mergeSettings(settingsOf(loaded.settings), options);
        part.scene = std::move(loaded.scene);
        SerialExecutor serial;
        moveInput(part, options, options.frame.value_or(0), serial);
    } catch (const InputError&) { // which all of the scene may do without
        return;
    }
    watch.part(std::move(part));
}

LoadedScene load(const CommonOptions& options, const MemoryBudget& memory, Executor& executor,
                 const InputWatch& watch) {
    ProgressBar bar(options.quiet, "files read");
    LoadOptions load;
    load.strict = options.strict;
    load.cache = !options.noCache;
    load.materials = options.materials;
    load.executor = &executor;
    load.memory = memory;
    load.progress = [&](size_t done, size_t total) {
        bar.show((int64_t) done, (int64_t) total);
        if (watch.progress) watch.progress(done, total);
    };
    if (watch.part && !options.camera) { // which may be of a model that is not there yet
        load.partial.wanted = watch.wanted;
        load.partial.show = [&](LoadedScene part) { showPart(std::move(part), options, watch); };
    }
    return loadScene(options.scene, load);
}

/// A place and a light that show the scene; the light beside the camera that there is.
Standpoint standpointOf(const LoadedScene& loaded, const CommonOptions& options,
                        const GridSettings& grid, Executor& executor) {
    const Scene& scene = loaded.scene;
    CameraHints hints;
    if (options.eye) hints.eye = scene.fromFiles(*options.eye);
    if (options.target) hints.target = scene.fromFiles(*options.target);
    if (loaded.hasCamera) {
        const Camera camera = mergeCamera(scene, options);
        hints.eye = camera.eye;
        hints.target = camera.target;
        hints.up = camera.up;
        hints.verticalFov = camera.verticalFov;
    }
    hints.up = options.up.value_or(hints.up);
    if (options.verticalFov) hints.verticalFov = options.verticalFov;
    hints.aspect = (float) grid.width / (float) grid.height;
    CpuBackend backend(executor);
    return chooseStandpoint(scene.mesh, backend, hints);
}

/// Tile and bins by the cost model, whose constants are the CPU's, where nothing else says them.
void chooseStructure(Input& input, const CommonOptions& options, const SceneSettings& file,
                     const Footprint& footprint) {
    if (options.backend != BackendKind::cpu) return;
    input.tileChosen = !options.tile && !file.tile;
    input.binsChosen = !options.bins && !file.bins;
    if (!input.tileChosen && !input.binsChosen) return;
    input.settings.grid = chooseGrid(footprint, input.settings, input.tileChosen, input.binsChosen);
}

bool usesCpu(const CommonOptions& options) {
    const auto& all = options.backends;
    return options.backend == BackendKind::cpu ||
           std::find(all.begin(), all.end(), BackendKind::cpu) != all.end();
}

/// Chooses the structure and makes sure that there is memory for a frame with it.
void chooseStructure(Input& input, const CommonOptions& options, const SceneSettings& file,
                     const MemoryBudget& memory, Executor& executor) {
    std::optional<Footprint> footprint;
    if (usesCpu(options)) {
        footprint.emplace(input.scene.mesh, input.scene.camera, input.settings.grid, executor);
        chooseStructure(input, options, file, *footprint);
    }
    const uint64_t frame =
        checkFrameMemory(input.scene, input.settings, footprint, options, memory);
    input.memory = {memory.limit(), memory.taken(), frame};
}

} // namespace

std::unique_ptr<Executor> makeExecutor(const CommonOptions& options) {
    auto pool = std::make_unique<ThreadPool>(options.threads);
    spareThreads();
    if (pool->missing() > 0)
        sayWarning(std::to_string(pool->missing()) + " of " +
                       std::to_string(pool->missing() + pool->threads()) +
                       " threads cannot be made: going on with " + std::to_string(pool->threads()),
                   options.quiet);
    return pool;
}

std::unique_ptr<Backend> makeBackend(BackendKind kind, const CommonOptions& options,
                                     Executor& executor) {
    switch (kind) {
    case BackendKind::gl:
#ifdef DIRT_HAVE_GL
        return std::make_unique<GlBackend>(GlOptions{.device = options.device});
#else
        throw CapabilityError("--backend gl: built without the OpenGL backend");
#endif
    case BackendKind::embree:
#ifdef DIRT_HAVE_EMBREE
        return std::make_unique<EmbreeBackend>(executor);
#else
        throw CapabilityError("--backend embree: built without Embree");
#endif
    default:
        return std::make_unique<CpuBackend>(executor);
    }
}

std::unique_ptr<Backend> makeBackend(const CommonOptions& options, Executor& executor) {
    return makeBackend(options.backend, options, executor);
}

Input openInput(const CommonOptions& options, Executor& executor, const InputWatch& watch) {
    checkCameraOptions(options);
    refuseIdleOptions(options);
    const MemoryBudget memory(sceneMemory(options));
    LoadedScene loaded = load(options, memory, executor, watch);
    sayAll(loaded, options.quiet);

    Input input;
    input.settings = mergeSettings(settingsOf(loaded.settings), options);
    refuseIdleOptions(options, input.settings);
    noteIdleOptions(options, loaded.scene);
    chooseCamera(loaded, options);
    const bool isBare = isModel(options.scene), needsLight = isBare && !loaded.hasLight;
    if (!loaded.hasCamera || needsLight) {
        const Standpoint standpoint = standpointOf(loaded, options, input.settings.grid, executor);
        if (!loaded.hasCamera) loaded.scene.camera = standpoint.camera;
        if (needsLight) loaded.scene.lights = {standpoint.light};
    }
    if (isBare) loaded.scene.background = glm::vec3(kModelBackground);
    if (input.settings.visibility == LightVisibility::shadowMap)
        for (const Spotlight& light : loaded.scene.lights)
            if (light.shadows) checkShadowMap(light);
    input.scene = std::move(loaded.scene);
    input.warnings = std::move(loaded.warnings);
    input.ignored = std::move(loaded.ignored);
    input.materialFiles = std::move(loaded.materialFiles);
    input.cameras = std::move(loaded.cameras);
    input.modelCamera = loaded.modelCamera;
    moveInput(input, options, options.frame.value_or(0), executor);
    checkPrecision(input, options, executor);
    chooseStructure(input, options, loaded.settings, memory, executor);
    return input;
}

void moveInput(Input& input, const CommonOptions& options, int frame, Executor& executor) {
    moveScene(input.scene, frame, executor);
    input.frame = frame;
    try {
        input.scene.camera = mergeCamera(input.scene, options);
    } catch (const InputError& error) {
        if (!input.scene.animation.camera) throw;
        throw InputError("frame " + std::to_string(frame) + ", " + error.what());
    }
}

void checkPrecision(Input& input, const CommonOptions& options, Executor& executor) {
    const Scene& scene = input.scene;
    input.precision = precisionReach(scene.mesh, scene.camera, input.settings.grid.mode, executor);
    std::string place = input.frame > 0 ? "frame " + std::to_string(input.frame) + ": " : "";
    for (const PrecisionWarning& found : precisionWarnings(input.precision)) {
        if (!input.precisionSaid.insert(found.cause).second) continue;
        const Warning warning{WarningKind::precision, atLine(options.scene, 0, place + found.text)};
        if (options.strict) throw InputError(warning.text);
        sayWarning(warning.text, options.quiet);
        input.warnings.push_back(warning);
    }
}

} // namespace dirt
