#pragma once

#include <chrono>
#include <cstdint>

namespace dirt {

/// A line on standard error that shows how far a render is and how long it will take. It shows
/// nothing where standard error is no terminal, or if \p quiet.
class ProgressBar {
public:
    explicit ProgressBar(bool quiet);
    ~ProgressBar() { clear(); }
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    /// \p done of \p total samples are finished.
    void show(int64_t done, int64_t total);
    /// Clears the line, for others to print.
    void clear();

private:
    bool shown_;
    std::chrono::steady_clock::time_point start_;
};

} // namespace dirt
