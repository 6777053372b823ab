#include "app/viewer/view_model.h"

#include "app/viewer/error_estimate.h"
#include "core/base/error.h"
#include "core/frame/renderer.h"
#include "core/path/tone_mapping.h"
#include "core/preview/present.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <utility>

namespace dirt {

namespace {

using Milliseconds = std::chrono::duration<double, std::milli>;

/// Pictures while the camera moves take no longer.
constexpr double kFrameMs = 1000.0 / 15;
/// A camera rests when it has not moved for so long.
constexpr std::chrono::milliseconds kRest{150};
/// Between two pictures of one that grows, but for its first samples.
constexpr double kShowMs = 100;
constexpr int kShownAtOnce = 8;
/// Of a picture that nothing else ends.
constexpr int kMostSamples = 1 << 20;
/// Coarser ones cannot be walked through.
constexpr double kLeastPixelShare = 1.0 / 64;

/// Ends a load that no one waits for any more.
struct Abandoned {};

/// As options and the scene's file have it.
ViewState firstState(const Input& input, const CommonOptions& options) {
    ViewState state;
    state.camera = input.scene.camera;
    state.settings = input.settings;
    state.backend = options.backend;
    const float radius = state.camera.apertureRadius;
    state.lensRadius = radius > 0.0f ? radius : 0.005f * (float) input.precision.diagonal;
    return state;
}

} // namespace

/// A state to draw.
struct ViewModel::Job {
    uint64_t change = 0;
    bool load = false, moving = false;
    ViewState state;
    std::function<bool()> stop{}; ///< of a scene that is not all there; else empty
};

ViewModel::ViewModel(const CommonOptions& options)
    : options_(options), thread_([this] { work(); }) {}

ViewModel::~ViewModel() {
    {
        const std::lock_guard lock(mutex_);
        quit_ = true;
    }
    changed_.notify_all();
    thread_.join();
}

bool ViewModel::loaded() const {
    const std::lock_guard lock(mutex_);
    return loaded_;
}

ViewState ViewModel::state() const {
    const std::lock_guard lock(mutex_);
    return state_;
}

uint64_t ViewModel::changes() const {
    const std::lock_guard lock(mutex_);
    return changes_;
}

std::optional<LoadingProgress> ViewModel::loading() const {
    const std::lock_guard lock(mutex_);
    return loading_;
}

std::shared_ptr<const ViewPicture> ViewModel::picture() const {
    const std::lock_guard lock(mutex_);
    return picture_;
}

std::string ViewModel::problem() const {
    const std::lock_guard lock(mutex_);
    return problem_;
}

double ViewModel::extent() const {
    const std::lock_guard lock(mutex_);
    return extent_;
}

std::string ViewModel::sceneName() const {
    const std::lock_guard lock(mutex_);
    return name_;
}

glm::dvec3 ViewModel::origin() const {
    const std::lock_guard lock(mutex_);
    return origin_;
}

void ViewModel::change(const std::function<void(ViewState&)>& edit, bool moving) {
    {
        const std::lock_guard lock(mutex_);
        if (!loaded_) return;
        edit(state_);
        ++changes_;
        problem_.clear();
        if (moving) moved_ = Clock::now();
    }
    changed_.notify_all();
}

void ViewModel::reload() {
    {
        const std::lock_guard lock(mutex_);
        reload_ = true;
        loading_ = LoadingProgress{};
        ++changes_;
        problem_.clear();
    }
    changed_.notify_all();
}

bool ViewModel::isMoving() const {
    return Clock::now() - moved_ < kRest;
}

bool ViewModel::isStale(const Job& job) const {
    const std::lock_guard lock(mutex_);
    return quit_ || changes_ != job.change;
}

/// Waits for something to do; false: there will be nothing any more.
bool ViewModel::next(Job& job) {
    std::unique_lock lock(mutex_);
    if (!reload_) loading_.reset(); // it has come to its end, good or bad
    changed_.wait(lock, [&] { return quit_ || reload_ || (loaded_ && finished_ != changes_); });
    // What has its coarse picture waits for the camera to move on, or to rest.
    changed_.wait_until(lock, moved_ + kRest,
                        [&] { return quit_ || reload_ || coarse_ != changes_; });
    if (quit_) return false;
    job = {changes_, reload_, isMoving(), state_};
    if (job.moving) coarse_ = changes_;
    reload_ = false;
    return true;
}

void ViewModel::work() {
    Job job;
    while (next(job)) {
        std::string problem;
        try {
            if (!executor_) executor_ = makeExecutor(options_);
            if (job.load)
                load(job);
            else
                draw(job);
            continue;
        } catch (const std::bad_alloc&) {
            problem = "out of memory: a smaller window, fewer bins or a larger tile needs less";
        } catch (const std::exception& error) {
            problem = error.what();
        }
        // What failed is not tried again before something changes.
        backend_.reset();
        const std::lock_guard lock(mutex_);
        problem_ = problem.substr(0, problem.find('\n'));
        if (!job.load || !loaded_) finished_ = job.change;
    }
    backend_.reset(); // on the thread that made it
}

/// Until there is a scene to look at, draws the parts that there are.
void ViewModel::load(const Job& job) {
    LoadingWatch watch;
    watch.progress = [&](size_t done, size_t of) {
        const std::lock_guard lock(mutex_);
        if (quit_ || reload_) throw Abandoned();
        loading_ = LoadingProgress{done, of};
    };
    if (!loaded())
        watch.draw = [&](Input part, const std::function<bool()>& isOver) {
            input_ = std::move(part);
            const auto stop = [&] { return isOver() || isStale(job); };
            draw({job.change, false, true, firstState(input_, options_), stop});
            input_ = Input(); // all of it will need the memory
        };
    Input input;
    try {
        input = openWatched(options_, watch);
    } catch (const Abandoned&) {
        return;
    }
    input_ = std::move(input);
    backend_.reset(); // reads its shaders again
    const std::lock_guard lock(mutex_);
    extent_ = input_.precision.diagonal;
    name_ = input_.scene.name;
    origin_ = input_.scene.origin;
    finished_ = changes_++; // so that it is drawn
    if (loaded_) return;
    loaded_ = true;
    state_ = firstState(input_, options_);
}

void ViewModel::draw(const Job& job) {
    if (!backend_ || backendKind_ != job.state.backend) {
        backend_.reset();
        backend_ = makeBackend(job.state.backend, options_, *executor_);
        backendKind_ = job.state.backend;
    }
    input_.scene.camera = job.state.camera;
    if (job.state.shown->of != PreviewKind::Of::image || job.state.ray)
        drawBuffer(job);
    else if (!job.moving)
        drawImage(job, job.state.settings);
    else {
        RenderSettings settings = job.state.settings;
        const double side = std::sqrt(pixelShare_);
        settings.grid.width = std::max(1, (int) std::lround(settings.grid.width * side));
        settings.grid.height = std::max(1, (int) std::lround(settings.grid.height * side));
        const auto start = Clock::now();
        drawImage(job, settings);
        const double ms = Milliseconds(Clock::now() - start).count();
        // Part of the time does not depend on the pixels, so that the share comes near by steps.
        pixelShare_ *= std::clamp(kFrameMs / ms, 0.5, 1.5);
        pixelShare_ = std::clamp(pixelShare_, kLeastPixelShare, 1.0);
    }
}

/// At rest, until the state changes; while the camera moves, one sample, whatever happens: or else
/// nothing would be seen of a movement that does not pause.
void ViewModel::drawImage(const Job& job, RenderSettings settings) {
    settings.samples =
        job.moving || !job.state.progressive ? 1 : options_.samples.value_or(kMostSamples);
    ErrorEstimate error;
    const auto start = Clock::now();
    auto shown = start;
    RenderHooks hooks;
    if (!job.moving) hooks.stop = [&] { return isStale(job); };
    if (job.stop) hooks.stop = job.stop;
    const DisplayEncoding encode(input_.scene.toneMapping);
    const auto finish = [&](Image image, int samples) {
        ViewPicture picture;
        picture.width = image.width, picture.height = image.height, picture.samples = samples;
        picture.picture = Picture(image.width, image.height);
        picture.picture.rgb = encode.bytes(image.pixels);
        picture.image = std::move(image);
        picture.error = error.relative();
        picture.sampleMs = Milliseconds(Clock::now() - start).count() / samples;
        return picture;
    };
    hooks.progress = [&](int done, int total) {
        if (done == total) return;
        Image image = meanImage(*backend_, settings.grid, done);
        error.add(image);
        const auto now = Clock::now();
        if (done > kShownAtOnce && Milliseconds(now - shown).count() < kShowMs) return;
        shown = now;
        publish(job, finish(std::move(image), done));
    };
    RenderResult result = Renderer(input_.scene, settings, *backend_).render(hooks);
    if (result.samples < settings.samples) return; // there is something new to draw
    if (!job.moving) error.add(result.image);
    ViewPicture picture = finish(std::move(result.image), result.samples);
    picture.done = !job.moving;
    picture.build = std::move(result.build), picture.passes = std::move(result.passes);
    publish(job, std::move(picture));
}

void ViewModel::drawBuffer(const Job& job) {
    PreviewRequest request;
    request.kind = job.state.shown;
    if (request.kind->of == PreviewKind::Of::overview) request.around = previewKind("entries");
    if (job.state.ray && request.kind->of != PreviewKind::Of::light) {
        const GridSettings& grid = job.state.settings.grid; // which may have shrunk since
        request.path = PathRequest{{std::min((*job.state.ray)[0], grid.width - 1),
                                    std::min((*job.state.ray)[1], grid.height - 1)},
                                   {}};
    }
    RenderSettings settings = job.state.settings;
    settings.samples = 1; // of the image below a ray, or amid the views
    const auto start = Clock::now();
    const auto stop = [&] { return isStale(job) && !job.moving; };
    const PreviewPicture preview = drawPreview(input_.scene, settings, *backend_, request, stop);
    if (stop()) return;
    ViewPicture picture;
    picture.picture = present(preview);
    picture.width = settings.grid.width, picture.height = settings.grid.height;
    picture.samples = 1;
    picture.scale = preview.scale;
    picture.done = !job.moving;
    picture.sampleMs = Milliseconds(Clock::now() - start).count();
    publish(job, std::move(picture));
}

void ViewModel::publish(const Job& job, ViewPicture picture) {
    picture.change = job.change;
    picture.loading = (bool) job.stop;
    picture.bytes = totalBytes(backend_->memory());
    picture.listEntries = backend_->listEntries();
    picture.device = backend_->device();
    const std::lock_guard lock(mutex_);
    if (picture.build.empty() && picture_) // of the last whole frame
        picture.build = picture_->build, picture.passes = picture_->passes;
    if (picture.done && changes_ == job.change) finished_ = job.change;
    picture_ = std::make_shared<const ViewPicture>(std::move(picture));
}

} // namespace dirt
