#include "app/viewer/scene_loading.h"

#include "backend_cpu/thread_pool.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <future>
#include <mutex>
#include <optional>
#include <utility>

namespace dirt {

namespace {

/// Hands parts of a scene from the thread that reads to the one that draws, one at a time.
class PartQueue {
public:
    /// Whether it is time for another picture: small scenes are there before.
    bool wanted() {
        const std::lock_guard lock(mutex_);
        const auto now = Clock::now();
        if (drawing_ || now - last_ < std::max<Clock::duration>(kLeast, kReading * cost_))
            return false;
        begin_ = now;
        return true;
    }

    void put(Input part) {
        {
            const std::lock_guard lock(mutex_);
            part_ = std::move(part);
            drawing_ = true;
        }
        changed_.notify_all();
    }

    /// Waits for one; none: all of the scene is there.
    std::optional<Input> take() {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [this] { return part_ || over_; });
        if (over_) return std::nullopt;
        return std::exchange(part_, std::nullopt);
    }

    /// What was taken last.
    void drawn() {
        const std::lock_guard lock(mutex_);
        last_ = Clock::now();
        cost_ = last_ - begin_;
        drawing_ = false;
    }

    void end() {
        {
            const std::lock_guard lock(mutex_);
            over_ = true;
        }
        changed_.notify_all();
    }

    bool isOver() const {
        const std::lock_guard lock(mutex_);
        return over_;
    }

private:
    using Clock = std::chrono::steady_clock;
    static constexpr std::chrono::milliseconds kLeast{100}; ///< between two pictures
    static constexpr int kReading = 2;                      ///< times what a picture takes

    mutable std::mutex mutex_;
    std::condition_variable changed_;
    std::optional<Input> part_;
    bool drawing_ = false, over_ = false;
    Clock::time_point last_ = Clock::now(), begin_{};
    Clock::duration cost_{}; ///< of the last picture, with the making of its scene
};

} // namespace

std::string loadingText(const std::string& file, const LoadingProgress& progress) {
    const std::string text = "loading " + file;
    if (progress.of == 0) return text;
    return text + ": " + std::to_string(progress.done) + " of " + std::to_string(progress.of) +
           " files";
}

Input openWatched(const CommonOptions& options, const LoadingWatch& watch) {
    PartQueue parts;
    InputWatch reading;
    reading.progress = watch.progress;
    if (watch.draw) {
        reading.wanted = [&] { return parts.wanted(); };
        reading.part = [&](Input part) { parts.put(std::move(part)); };
    }
    std::future<Input> opened = std::async(std::launch::async, [&] {
        struct End {
            PartQueue& parts;
            ~End() { parts.end(); }
        } const end{parts};
        ThreadPool threads(options.threads); // the caller's serve the backend that draws
        return openInput(options, threads, reading);
    });
    try {
        while (std::optional<Input> part = parts.take()) {
            watch.draw(std::move(*part), [&] { return parts.isOver(); });
            parts.drawn();
        }
    } catch (const std::exception&) { // no further part is wanted, as this one is never drawn
    }
    return opened.get();
}

} // namespace dirt
