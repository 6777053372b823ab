#pragma once

#include "core/frame/backend.h"

#include <chrono>
#include <string>
#include <vector>

namespace dirt {

/// Adds up the time of each pass and event over the samples of a frame, in the order of their
/// first run: the device's, where the backend has such a clock, or the host's.
class PassClock {
public:
    explicit PassClock(Backend& backend) : backend_(backend) {
        backend_.takePassTimes(); // of a frame that was given up
    }

    /// Runs \p pass as the pass \p name of \p event.
    template <typename Pass>
    void time(const char* name, int event, const Pass& pass) {
        const size_t index = indexOf(name, event);
        const auto start = std::chrono::steady_clock::now();
        backend_.beginTimedPass();
        pass();
        backend_.endTimedPass();
        const std::chrono::duration<double, std::milli> spent =
            std::chrono::steady_clock::now() - start;
        runs_.push_back({index, spent.count()});
    }

    /// All there are; once, at the end.
    std::vector<PassTime> take() {
        const std::vector<double> device = backend_.takePassTimes();
        for (size_t i = 0; i < runs_.size(); ++i)
            times_[runs_[i].index].ms += device.size() == runs_.size() ? device[i] : runs_[i].ms;
        runs_.clear();
        return std::move(times_);
    }

private:
    struct Run {
        size_t index; ///< of times_
        double ms;    ///< of the host
    };

    size_t indexOf(const char* name, int event) {
        for (size_t i = 0; i < times_.size(); ++i)
            if (times_[i].event == event && times_[i].name == name) return i;
        times_.push_back(PassTime{name, 0.0, event});
        return times_.size() - 1;
    }

    Backend& backend_;
    std::vector<PassTime> times_;
    std::vector<Run> runs_;
};

} // namespace dirt
