#include "app/cli/progress_bar.h"

#include <cstdio>
#include <string>

#include <unistd.h>

namespace dirt {

namespace {

constexpr int kWidth = 32;

/// "1:05" or "2:00:07".
std::string clockText(double seconds) {
    const long whole = (long) (seconds + 0.5);
    char text[32];
    if (whole < 3600)
        std::snprintf(text, sizeof text, "%ld:%02ld", whole / 60, whole % 60);
    else
        std::snprintf(text, sizeof text, "%ld:%02ld:%02ld", whole / 3600, whole / 60 % 60,
                      whole % 60);
    return text;
}

} // namespace

ProgressBar::ProgressBar(bool quiet, const char* what)
    : shown_(!quiet && isatty(STDERR_FILENO) == 1), what_(what),
      start_(std::chrono::steady_clock::now()) {}

void ProgressBar::clear() {
    if (shown_) std::fputs("\r\033[K", stderr);
}

void ProgressBar::show(int64_t done, int64_t total) {
    if (!shown_) return;
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start_;
    const int filled = (int) (kWidth * done / total);
    const std::string bar =
        std::string((size_t) filled, '#') + std::string((size_t) (kWidth - filled), '.');
    std::fprintf(stderr, "\r[%s] %lld of %lld %s", bar.c_str(), (long long) done, (long long) total,
                 what_);
    if (done > 0)
        std::fprintf(stderr, ", %s left",
                     clockText(spent.count() * (double) (total - done) / (double) done).c_str());
    std::fputs("\033[K", stderr);
    std::fflush(stderr);
}

} // namespace dirt
