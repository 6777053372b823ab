#pragma once

#include <chrono>
#include <cstdint>

namespace dirt {

/// A line on standard error that shows how far a work is and how long it will take. It shows
/// nothing where standard error is no terminal, or if \p quiet.
class ProgressBar {
public:
    /// \p what: the things that are counted.
    explicit ProgressBar(bool quiet, const char* what = "samples");
    ~ProgressBar() { clear(); }
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    /// \p done of \p total are finished.
    void show(int64_t done, int64_t total);
    /// Clears the line, for others to print.
    void clear();

private:
    bool shown_;
    const char* what_;
    std::chrono::steady_clock::time_point start_;
};

} // namespace dirt
