#pragma once

#include "app/viewer/view_drawer.h"

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace dirt {

/// The viewer without its window: a scene, the state that keys change, and a thread that draws what
/// the state says. While the camera or the scene moves, pictures have as many pixels as can be
/// drawn in a fifteenth of a second; at rest samples add up in all pixels, to the image that `dirt
/// render` gives for as many, until the state changes. The first time that a scene is loaded,
/// pictures show the objects that are there already. Functions may be called from any one thread,
/// and do not wait for a picture.
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
    /// Reads the scene's file and the shaders again; what is being read is given up after the files
    /// at hand. What fails of it stays as it was.
    void reload();
    /// Loads another scene, by a camera of its own, with what was chosen for the window kept. If
    /// that fails, the one that is there stays.
    void open(const std::string& file);

    /// How far the scene is that is being loaded; none: it is there, or could not be loaded.
    std::optional<LoadingProgress> loading() const;
    /// That is there, or is being loaded.
    std::string file() const;

    /// The newest picture; null before the first.
    std::shared_ptr<const ViewPicture> picture() const;
    /// What went wrong last; empty: nothing since the last change.
    std::string problem() const;

    /// What is known of the scene.
    struct Facts {
        std::string file;
        std::string name;       ///< empty before it is there, as all that follows
        double extent = 0.0;    ///< the length of the diagonal of its box
        glm::dvec3 origin{0.0}; ///< of its coordinates, in those of its files
        size_t triangles = 0, materials = 0, textures = 0, lights = 0;
        int lastFrame = 0; ///< 0: nothing moves
        double framesPerSecond = 0.0;
        uint64_t bytes = 0; ///< that it takes
    };
    Facts facts() const;

private:
    using Clock = std::chrono::steady_clock;
    struct Job;

    void work();
    bool next(Job& job);
    void load(const Job& job);
    void draw(Job& job);
    void publish(const Job& job, ViewPicture picture);
    bool isStale(const Job& job) const;
    bool isMoving() const;
    bool isPlaying() const;
    Clock::time_point advance();

    CommonOptions options_;    ///< of the thread alone, as is drawer_
    mutable std::mutex mutex_; ///< of what follows, up to the thread's own
    std::condition_variable changed_;
    ViewState state_;
    Facts facts_;
    bool loaded_ = false, reload_ = true, quit_ = false;
    std::string file_; ///< to be loaded
    std::optional<LoadingProgress> loading_ = LoadingProgress{};
    uint64_t changes_ = 0, finished_ = 0; ///< the change whose picture has all its samples
    uint64_t coarse_ = 0;                 ///< and the last that was drawn while the camera moved
    Clock::time_point moved_{}, played_{};
    double place_ = 0.0; ///< in the animation, frames
    std::shared_ptr<const ViewPicture> picture_;
    std::string problem_;

    ViewDrawer drawer_;
    std::thread thread_;
};

} // namespace dirt
