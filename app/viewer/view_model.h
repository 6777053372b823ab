#pragma once

#include "app/cli/input.h"
#include "app/viewer/scene_loading.h"
#include "app/viewer/view_state.h"
#include "core/base/image.h"
#include "core/frame/tracer.h"
#include "core/preview/picture.h"

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace dirt {

/// A picture of the view, and what it is of. Not changed once it is shown.
struct ViewPicture {
    Picture picture;                        ///< as a screen shows it
    Image image;                            ///< its values, where it is the image
    uint64_t change = 0;                    ///< the last change of the state that it has
    int width = 0, height = 0, samples = 0; ///< of the image behind it
    double error = 0.0;                     ///< relative, see ErrorEstimate
    bool done = false;                      ///< no more samples will come
    bool loading = false;                   ///< of a scene that was not all there
    std::vector<PassTime> build, passes;    ///< of its last frame; passes: with those of the build
    double sampleMs = 0.0;                  ///< from the beginning of the build, for each sample
    uint64_t bytes = 0, listEntries = 0;    ///< of the backend's buffers
    std::string device, scale;              ///< scale: what false colours stand for
};

/// The viewer without its window: a scene, the state that keys change, and a thread that draws what
/// the state says. While the camera moves, pictures have as many pixels as can be drawn in a
/// fifteenth of a second; at rest samples add up in all pixels, to the image that `dirt render`
/// gives for as many, until the state changes. The first time that a scene is loaded, pictures show
/// the objects that are there already. Functions may be called from any one thread, and do
/// not wait for a picture.
class ViewModel {
public:
    /// Begins to load the scene of \p options, whose samples, where they are given, are the most.
    explicit ViewModel(const CommonOptions& options);
    ~ViewModel();
    ViewModel(const ViewModel&) = delete;
    ViewModel& operator=(const ViewModel&) = delete;

    /// Whether there is a scene, and so a state to change.
    bool loaded() const;
    ViewState state() const;
    /// Changes the state; before a scene is there, nothing. \p moving: more of the kind will follow
    /// soon, so that a coarse picture at once is worth more than a fine one.
    void change(const std::function<void(ViewState&)>& edit, bool moving = false);
    /// How many changes there were; a picture says which was its last.
    uint64_t changes() const;
    /// Reads the scene's file again; what is being read is given up after the file at hand. If that
    /// fails, the one that is there stays.
    void reload();
    /// How far the scene is that is being loaded; none: it is there, or could not be loaded.
    std::optional<LoadingProgress> loading() const;

    /// The newest picture; null before the first.
    std::shared_ptr<const ViewPicture> picture() const;
    /// What went wrong last; empty: nothing since the last change.
    std::string problem() const;
    /// The length of the diagonal of the scene's box; 0 before it is there.
    double extent() const;
    const CommonOptions& options() const { return options_; }
    std::string sceneName() const;
    /// Of the scene, in the coordinates of its files.
    glm::dvec3 origin() const;

private:
    using Clock = std::chrono::steady_clock;
    struct Job;

    void work();
    bool next(Job& job);
    void load(const Job& job);
    void draw(const Job& job);
    void drawImage(const Job& job, RenderSettings settings);
    void drawBuffer(const Job& job);
    void publish(const Job& job, ViewPicture picture);
    bool isStale(const Job& job) const;
    bool isMoving() const;

    const CommonOptions options_;
    mutable std::mutex mutex_; ///< of what follows, up to the thread's own
    std::condition_variable changed_;
    ViewState state_;
    bool loaded_ = false, reload_ = true, quit_ = false;
    uint64_t changes_ = 0, finished_ = 0; ///< the change whose picture has all its samples
    uint64_t coarse_ = 0;                 ///< and the last that was drawn while the camera moved
    Clock::time_point moved_{};
    std::shared_ptr<const ViewPicture> picture_;
    std::string problem_, name_;
    std::optional<LoadingProgress> loading_ = LoadingProgress{};
    double extent_ = 0.0;
    glm::dvec3 origin_{0.0};

    // Of the thread alone.
    Input input_;
    std::unique_ptr<Executor> executor_;
    std::unique_ptr<Backend> backend_;
    BackendKind backendKind_{};
    double pixelShare_ = 1.0 / 16; ///< of the pixels at rest, while the camera moves
    std::thread thread_;
};

} // namespace dirt
