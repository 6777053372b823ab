#pragma once

#include <ctime>

namespace dirt::test {

/// Seconds of processor time that \p body takes, on all threads of the process.
template <typename Body>
double processorTime(Body&& body) {
    const auto now = [] {
        timespec time{};
        clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
        return (double) time.tv_sec + 1e-9 * (double) time.tv_nsec;
    };
    const double start = now();
    body();
    return now() - start;
}

/// What no input of a megabyte may take to read. Such as grow with the square of their length take
/// minutes.
inline constexpr double kGenerous = 10.0;

} // namespace dirt::test
