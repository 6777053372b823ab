#include "app/cli/interrupt.h"

#include <atomic>

#include <signal.h>
#include <unistd.h>

namespace dirt {

namespace {

std::atomic<bool> stopRequested{false};
static_assert(std::atomic<bool>::is_always_lock_free, "set from a signal handler");

void onInterrupt(int) {
    if (stopRequested.exchange(true)) _exit(kInterrupted);
}

} // namespace

void catchInterrupts() {
    struct sigaction action {};
    action.sa_handler = onInterrupt;
    action.sa_flags = SA_RESTART; // writing what is done must not fail halfway
    sigaction(SIGINT, &action, nullptr);
}

bool interrupted() {
    return stopRequested.load();
}

} // namespace dirt
