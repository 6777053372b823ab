#include "app/cli/interrupt.h"

#include "core/io/output_file.h"

#include <atomic>

#include <signal.h>

namespace dirt {

namespace {

std::atomic<bool> stopRequested{false};
static_assert(std::atomic<bool>::is_always_lock_free, "set from a signal handler");

void exitNow(int) {
    exitBetweenFiles(kInterrupted);
}

void onInterrupt(int signal) {
    if (stopRequested.exchange(true)) exitNow(signal);
}

void handle(void (*handler)(int)) {
    struct sigaction action {};
    action.sa_handler = handler;
    action.sa_flags = SA_RESTART; // writing what is done must not fail halfway
    sigaction(SIGINT, &action, nullptr);
}

} // namespace

void exitOnInterrupt() {
    handle(exitNow);
}

void catchInterrupts() {
    handle(onInterrupt);
}

bool interrupted() {
    return stopRequested.load();
}

} // namespace dirt
