#include "app/viewer/view_drawer.h"

#include "app/viewer/details.h"
#include "app/viewer/error_estimate.h"
#include "core/frame/renderer.h"
#include "core/path/camera_rays.h"
#include "core/path/tone_mapping.h"
#include "core/preview/path_marks.h"
#include "core/preview/present.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string_view>
#include <utility>

namespace dirt {

namespace {

using Clock = std::chrono::steady_clock;
using Milliseconds = std::chrono::duration<double, std::milli>;

/// Pictures while something moves take no longer.
constexpr double kFrameMs = 1000.0 / 15;
/// Between two pictures of one that grows, but for its first samples.
constexpr double kShowMs = 100;
constexpr int kShownAtOnce = 8;
/// Of a picture that nothing else ends.
constexpr int kMostSamples = 1 << 20;
/// Coarser ones cannot be walked through.
constexpr double kLeastPixelShare = 1.0 / 64;
constexpr Colour kTileMark{255, 255, 255};

double msSince(Clock::time_point start) {
    return Milliseconds(Clock::now() - start).count();
}

bool isImage(const ViewState& state) {
    return state.shown->of == PreviewKind::Of::image;
}

bool isSame(const Camera& a, const Camera& b) {
    return a.eye == b.eye && a.target == b.target && a.up == b.up &&
           a.verticalFov == b.verticalFov && a.apertureRadius == b.apertureRadius &&
           a.focalDistance == b.focalDistance;
}

/// Whether a path is the same in both.
bool hasSamePath(const ViewState& a, const ViewState& b) {
    return a.ray == b.ray && a.frame == b.frame && a.backend == b.backend &&
           a.settings == b.settings && isSame(a.camera, b.camera);
}

} // namespace

void ViewDrawer::open(const CommonOptions& options, const LoadProgress& progress, const Stop& stop,
                      const Show& showPart) {
    if (!executor_) executor_ = makeExecutor(options), threads_ = options.threads;
    LoadingWatch watch;
    watch.progress = progress;
    if (showPart)
        watch.draw = [&](Input part, const Stop& isOver) {
            input_ = std::move(part);
            options_ = options;
            ViewState state = firstState();
            prepare(state);
            drawOnce(
                state, coarse(state.settings), true, [&] { return isOver() || stop(); },
                [&](ViewPicture picture) {
                    picture.loading = true;
                    showPart(std::move(picture));
                });
            input_ = Input(); // all of it will need the memory
        };
    input_ = openWatched(options, watch);
    options_ = options;
    account_.reset();
}

ViewState ViewDrawer::firstState() const {
    ViewState state;
    state.camera = input_.scene.camera;
    state.settings = input_.settings;
    state.toneMapping = input_.scene.toneMapping;
    state.backend = options_.backend;
    state.threads = options_.threads;
    state.frame = input_.frame;
    state.playing = !input_.scene.animation.empty() && !options_.frame;
    const float radius = state.camera.apertureRadius;
    state.lensRadius = radius > 0.0f ? radius : 0.005f * (float) input_.precision.diagonal;
    return state;
}

void ViewDrawer::reloadShaders() {
    if (backend_) backend_->reloadShaders();
}

void ViewDrawer::forget() {
    account_.reset();
    backend_.reset();
}

void ViewDrawer::prepare(ViewState& state) {
    if (state.threads != threads_) {
        forget(); // whose threads they are
        options_.threads = state.threads;
        executor_ = makeExecutor(options_);
        threads_ = state.threads;
    }
    if (!backend_ || backendKind_ != state.backend) {
        backend_.reset();
        backend_ = makeBackend(state.backend, options_, *executor_);
        backendKind_ = state.backend;
        restMs_.reset(); // it may be far slower
    }
    Scene& scene = input_.scene;
    const bool hasMoved = state.frame != input_.frame;
    if (hasMoved) moveInput(input_, options_, state.frame, *executor_);
    if (hasMoved && scene.animation.camera)
        state.camera = scene.camera;
    else
        scene.camera = state.camera;
    scene.toneMapping = state.toneMapping;
}

RenderSettings ViewDrawer::coarse(RenderSettings settings) const {
    const double side = std::sqrt(pixelShare_);
    GridSettings& grid = settings.grid;
    grid.width = std::max(1, (int) std::lround(grid.width * side));
    grid.height = std::max(1, (int) std::lround(grid.height * side));
    return settings;
}

void ViewDrawer::draw(ViewState& state, bool moving, const Stop& stop, const Show& show) {
    prepare(state);
    // Tiles of a coarser picture would be others.
    const bool hasCoarse = state.shown->of != PreviewKind::Of::views;
    // Also before a fine one that will take its time, or may.
    if (hasCoarse && (moving || !restMs_ || *restMs_ > 2.0 * kFrameMs)) {
        const auto start = Clock::now();
        // It is finished whatever happens: or else nothing would be seen of a movement that does
        // not pause.
        drawOnce(state, coarse(state.settings), true, {}, show);
        // Part of the time does not depend on the pixels, so that the share comes near by steps.
        pixelShare_ *= std::clamp(kFrameMs / msSince(start), 0.5, 1.5);
        pixelShare_ = std::clamp(pixelShare_, kLeastPixelShare, 1.0);
    }
    if (moving && hasCoarse) return;
    const auto start = Clock::now();
    drawOnce(state, state.settings, moving, moving ? Stop() : stop,
             [&, isFirst = true](ViewPicture picture) mutable {
                 if (std::exchange(isFirst, false)) restMs_ = msSince(start);
                 show(std::move(picture));
             });
}

void ViewDrawer::drawOnce(const ViewState& state, const RenderSettings& settings, bool moving,
                          const Stop& stop, const Show& show) {
    if (isImage(state))
        drawImage(state, settings, moving, stop, show);
    else
        drawBuffer(state, settings, moving, stop, show);
}

/// The path of the state's pixel; null: there is none to be shown, or it was stopped.
const PathAccount* ViewDrawer::accountOf(const ViewState& state, const Stop& stop) {
    if (!state.ray || !backend_->hasGrid()) return nullptr;
    if (account_ && hasSamePath(state, accountState_)) return &*account_;
    account_.reset();
    const GridSettings& grid = state.settings.grid;
    const auto [x, y] = *state.ray;
    const size_t pixel = (size_t) std::min(y, grid.height - 1) * (size_t) grid.width +
                         (size_t) std::min(x, grid.width - 1); // the window may have shrunk
    PathAccount account = dirt::accountOf(input_.scene, state.settings, *backend_, pixel, 0, stop);
    if (!account.grid) return nullptr;
    account_ = std::move(account);
    accountState_ = state;
    return &*account_;
}

void ViewDrawer::drawImage(const ViewState& state, const RenderSettings& asked, bool moving,
                           const Stop& stop, const Show& show) {
    RenderSettings settings = asked;
    settings.samples = moving || !state.progressive ? 1 : options_.samples.value_or(kMostSamples);
    const PathAccount* const account = moving ? nullptr : accountOf(state, stop);
    std::vector<PathStep> path;
    if (account) path = pathOf(state, *account, {});
    ErrorEstimate error;
    const auto start = Clock::now();
    auto shown = start;
    RenderHooks hooks;
    hooks.stop = stop;
    const DisplayEncoding encode(input_.scene.toneMapping);
    const auto pictureOf = [&](Image image, int samples) {
        ViewPicture picture;
        picture.width = image.width, picture.height = image.height, picture.samples = samples;
        picture.picture = Picture(image.width, image.height);
        picture.picture.rgb = encode.bytes(image.pixels);
        picture.image = std::move(image);
        picture.error = error.relative();
        picture.sampleMs = msSince(start) / samples;
        picture.path = path;
        return picture;
    };
    hooks.progress = [&](int done, int total) {
        if (done == total) return;
        Image image = meanImage(*backend_, settings.grid, done);
        error.add(image);
        const auto now = Clock::now();
        if (done > kShownAtOnce && Milliseconds(now - shown).count() < kShowMs) return;
        shown = now;
        finish(pictureOf(std::move(image), done), show);
    };
    RenderResult result = Renderer(input_.scene, settings, *backend_).render(hooks);
    if (result.samples < settings.samples) return; // there is something new to draw
    if (!moving) error.add(result.image);
    ViewPicture picture = pictureOf(std::move(result.image), result.samples);
    picture.done = !moving;
    picture.build = std::move(result.build), picture.passes = std::move(result.passes);
    finish(std::move(picture), show);
}

void ViewDrawer::drawBuffer(const ViewState& state, const RenderSettings& asked, bool moving,
                            const Stop& stop, const Show& show) {
    using Of = PreviewKind::Of;
    RenderSettings settings = asked;
    settings.samples = 1; // of the image amid the views
    PreviewRequest request;
    request.kind = state.shown;
    const std::string_view name = state.shown->name;
    if (name == "near" || name == "far") request.level = state.level;
    if (name == "entries") request.bin = state.bin;
    if (request.kind->of == Of::event || request.kind->of == Of::point) request.event = state.event;
    if (request.kind->of == Of::overview) request.around = previewKind("entries");
    const auto start = Clock::now();
    const PathAccount* const account =
        moving || request.kind->of == Of::light ? nullptr : accountOf(state, stop);
    const PreviewPicture preview = drawPreview(input_.scene, settings, *backend_, request, stop);
    if (stop && stop()) return;
    ViewPicture picture;
    picture.picture = present(preview);
    picture.values = presentedValues(preview);
    picture.width = settings.grid.width, picture.height = settings.grid.height;
    picture.samples = 1;
    picture.scale = preview.scale;
    picture.done = !moving;
    if (!moving) tellTile(state, picture);
    if (account) picture.path = pathOf(state, *account, picture.values);
    picture.sampleMs = msSince(start);
    finish(std::move(picture), show);
}

/// Frames the tile that is asked about where it stands in the picture, and tells its lists.
void ViewDrawer::tellTile(const ViewState& state, ViewPicture& picture) const {
    if (!state.tile || !backend_->hasGrid()) return;
    const auto [view, column, row] = *state.tile;
    for (const PictureValues& part : picture.values) {
        const glm::ivec2 cell(column >> part.level, row >> part.level);
        if (part.view != view || cell.x >= part.columns() || cell.y >= part.rows()) continue;
        const glm::dvec2 corner =
            glm::dvec2(part.pixels.left, part.pixels.top) + glm::dvec2(cell * part.times);
        picture.marks = {{Mark::Shape::box, corner, corner + (double) part.times, kTileMark}};
        picture.told =
            tileText(input_.scene, backend_->readGrid(), backend_->readGeometry(), *state.tile);
        return;
    }
}

/// The steps of a path in a picture of cells, if it has \p parts of some, or of the image's pixels.
std::vector<PathStep> ViewDrawer::pathOf(const ViewState& state, const PathAccount& account,
                                         const std::vector<PictureValues>& parts) const {
    const GridSettings& grid = state.settings.grid;
    const CameraRays camera(input_.scene.camera, grid.width, grid.height, grid.mode);
    const bool hasCells = !parts.empty() && parts.front().view >= 0;
    std::vector<PathStep> path;
    for (const PathRequest& step : stepsOf(account, *state.ray)) {
        path.push_back({pathText(input_.scene, account, step), {}});
        std::vector<Mark>& marks = path.back().marks;
        if (hasCells)
            marks = placeMarks(marksOfPath(account, step, parts.front().level).marks, *account.grid,
                               parts);
        else
            marks = marksInImage(account, step, camera).marks;
        if (hasCells || parts.empty()) continue;
        for (Mark& mark : marks) // the picture of a buffer of pixels may be enlarged
            mark.from *= parts.front().times, mark.to *= parts.front().times;
    }
    return path;
}

void ViewDrawer::finish(ViewPicture picture, const Show& show) const {
    picture.frame = input_.frame;
    picture.box = input_.precision.box;
    picture.memory = backend_->memory();
    picture.listEntries = backend_->listEntries();
    picture.device = backend_->device();
    show(std::move(picture));
}

} // namespace dirt
