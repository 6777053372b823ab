#pragma once

#include <chrono>

namespace dirt {

/// A line on standard error that shows how far a render is and how long it will take. It shows
/// nothing where standard error is no terminal, or if \p quiet.
class ProgressBar {
public:
    explicit ProgressBar(bool quiet);
    /// Clears the line.
    ~ProgressBar();
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    /// \p done of \p total samples are finished.
    void show(int done, int total);

private:
    bool shown_;
    std::chrono::steady_clock::time_point start_;
};

} // namespace dirt
