#pragma once

#include "core/frame/tracer.h"

#include <chrono>
#include <string>
#include <vector>

namespace dirt {

/// Adds up the time of each pass and event over the samples of a frame, in the order of their
/// first run.
class PassClock {
public:
    /// Runs \p pass as the pass \p name of \p event.
    template <typename Pass>
    void time(const char* name, int event, const Pass& pass) {
        const auto start = std::chrono::steady_clock::now();
        pass();
        const std::chrono::duration<double, std::milli> spent =
            std::chrono::steady_clock::now() - start;
        entry(name, event).ms += spent.count();
    }

    const std::vector<PassTime>& times() const { return times_; }

private:
    PassTime& entry(const char* name, int event) {
        for (PassTime& time : times_)
            if (time.event == event && time.name == name) return time;
        return times_.emplace_back(PassTime{name, 0.0, event});
    }

    std::vector<PassTime> times_;
};

} // namespace dirt
