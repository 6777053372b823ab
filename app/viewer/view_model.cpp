#include "app/viewer/view_model.h"

#include "app/cli/log.h"
#include <algorithm>
#include <cmath>
#include <new>
#include <utility>

namespace dirt {

namespace {

/// A camera rests when it has not moved for so long.
constexpr std::chrono::milliseconds kRest{150};

/// Ends a load that no one waits for any more.
struct Abandoned {};

} // namespace

/// A state to draw.
struct ViewModel::Job {
    uint64_t change = 0;
    bool load = false, moving = false;
    std::string file; ///< to be loaded
    ViewState state;
};

ViewModel::ViewModel(const CommonOptions& options)
    : options_(options), file_(options.scene), thread_([this] { work(); }) {}

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

std::string ViewModel::file() const {
    const std::lock_guard lock(mutex_);
    return file_;
}

std::shared_ptr<const ViewPicture> ViewModel::picture() const {
    const std::lock_guard lock(mutex_);
    return picture_;
}

std::string ViewModel::problem() const {
    const std::lock_guard lock(mutex_);
    return problem_;
}

ViewModel::Facts ViewModel::facts() const {
    const std::lock_guard lock(mutex_);
    return facts_;
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
    open("");
}

void ViewModel::open(const std::string& file) {
    {
        const std::lock_guard lock(mutex_);
        if (!file.empty()) file_ = file;
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

bool ViewModel::isPlaying() const {
    return loaded_ && state_.playing && facts_.lastFrame > 0;
}

bool ViewModel::isStale(const Job& job) const {
    const std::lock_guard lock(mutex_);
    return quit_ || changes_ != job.change;
}

/// Goes on in the animation by the time that has passed, and says when the next frame is due.
ViewModel::Clock::time_point ViewModel::advance() {
    const auto now = Clock::now();
    const std::chrono::duration<double> passed = now - std::exchange(played_, now);
    if ((int) place_ != state_.frame) place_ = state_.frame; // it was put there, or stood there
    place_ += std::min(passed.count(), 1.0) * facts_.framesPerSecond; // no leap after a pause
    const double frames = facts_.lastFrame + 1;
    place_ -= frames * std::floor(place_ / frames);
    state_.frame = std::clamp((int) place_, 0, facts_.lastFrame);
    const double left = (std::floor(place_) + 1.0 - place_) / facts_.framesPerSecond;
    return now + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(left));
}

/// Waits for something to do; false: there will be nothing any more.
bool ViewModel::next(Job& job) {
    std::unique_lock lock(mutex_);
    if (!reload_) loading_.reset(); // it has come to its end, good or bad
    changed_.wait(lock, [&] {
        return quit_ || reload_ || isPlaying() || (loaded_ && finished_ != changes_);
    });
    if (isPlaying()) {
        const int last = state_.frame;
        const auto due = advance();
        if (state_.frame == last && coarse_ == changes_) {
            changed_.wait_until(
                lock, due, [&] { return quit_ || reload_ || coarse_ != changes_ || !isPlaying(); });
            if (isPlaying()) advance();
        }
    } else
        // What has its coarse picture waits for the camera to move on, or to rest.
        changed_.wait_until(lock, moved_ + kRest,
                            [&] { return quit_ || reload_ || coarse_ != changes_; });
    if (quit_) return false;
    job = {changes_, std::exchange(reload_, false), isMoving() || isPlaying(), file_, state_};
    if (job.moving) coarse_ = changes_;
    return true;
}

void ViewModel::work() {
    Job job;
    while (next(job)) {
        std::string problem;
        try {
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
        if (!job.load) drawer_.forget();
        problem = problem.substr(0, problem.find('\n'));
        logOnly(LogLevel::error, problem); // the window shows it
        // What failed is not tried again before something changes.
        const std::lock_guard lock(mutex_);
        problem_ = problem;
        if (!job.load) state_.playing = false;
        if (!job.load || !loaded_) finished_ = job.change;
    }
    drawer_.forget(); // on the thread that made it
}

/// Until there is a scene to look at, shows the parts that there are.
void ViewModel::load(const Job& job) {
    CommonOptions options = options_;
    const bool isOther = options.scene != job.file;
    if (isOther) { // what was said of the first scene is not of this one
        options.scene = job.file;
        options.camera.reset(), options.eye.reset(), options.target.reset();
        options.up.reset(), options.verticalFov.reset(), options.frame.reset();
    }
    const auto progress = [&](size_t done, size_t of) {
        const std::lock_guard lock(mutex_);
        if (quit_ || reload_) throw Abandoned();
        loading_ = LoadingProgress{done, of};
    };
    ViewDrawer::Show showPart;
    if (!loaded()) showPart = [&](ViewPicture picture) { publish(job, std::move(picture)); };
    try {
        drawer_.open(
            options, progress, [&] { return isStale(job); }, showPart);
    } catch (const Abandoned&) {
        return;
    } catch (...) {
        const std::lock_guard lock(mutex_);
        if (loaded_ && !reload_) file_ = options_.scene;
        throw;
    }
    options_ = options;
    {
        const std::lock_guard lock(mutex_);
        const Input& input = drawer_.input();
        facts_ = {job.file,
                  input.scene.name,
                  input.precision.diagonal,
                  input.scene.origin,
                  input.scene.mesh.triangles.size(),
                  input.scene.materials.size(),
                  input.scene.textures.size(),
                  input.scene.lights.size(),
                  input.scene.animation.lastFrame(),
                  input.scene.animation.fps,
                  input.memory.scene};
        finished_ = changes_++; // so that it is drawn
        state_.frame = input.frame;
        if (!loaded_ || isOther) {
            const ViewState before = std::exchange(state_, drawer_.firstState());
            if (loaded_) { // of the window, not of the scene
                state_.settings.grid.width = before.settings.grid.width;
                state_.settings.grid.height = before.settings.grid.height;
                state_.backend = before.backend;
                state_.threads = before.threads;
                state_.progressive = before.progressive;
                state_.shown = before.shown;
            }
        }
        loaded_ = true;
    }
    drawer_.reloadShaders();
}

void ViewModel::draw(Job& job) {
    drawer_.draw(
        job.state, job.moving, [&] { return isStale(job); },
        [&](ViewPicture picture) { publish(job, std::move(picture)); });
}

void ViewModel::publish(const Job& job, ViewPicture picture) {
    picture.change = job.change;
    const std::lock_guard lock(mutex_);
    if (picture.build.empty() && picture_) // of the last whole frame
        picture.build = picture_->build, picture.passes = picture_->passes;
    if (changes_ == job.change) {
        state_.camera = job.state.camera; // which may move by itself
        if (picture.done) finished_ = job.change;
    }
    picture_ = std::make_shared<const ViewPicture>(std::move(picture));
}

} // namespace dirt
