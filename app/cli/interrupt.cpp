#include "app/cli/interrupt.h"

#include "core/io/output_file.h"

#include <atomic>

#include <signal.h>

namespace dirt {

namespace {

/// The first signal; 0: none yet.
std::atomic<int> stopRequested{0};
static_assert(std::atomic<int>::is_always_lock_free, "set from a signal handler");

constexpr int statusOf(int signal) {
    return 128 + signal; // as shells have it
}

void exitNow(int signal) {
    exitBetweenFiles(statusOf(signal));
}

void onInterrupt(int signal) {
    if (stopRequested.exchange(signal) != 0) exitNow(signal);
}

void handle(int signal, void (*handler)(int)) {
    struct sigaction action {};
    action.sa_handler = handler;
    action.sa_flags = SA_RESTART; // writing what is done must not fail halfway
    sigaction(signal, &action, nullptr);
}

bool isIgnored(int signal) {
    struct sigaction action {};
    return sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

void handleInterrupts(void (*handler)(int)) {
    handle(SIGINT, handler);
    for (const int signal : {SIGTERM, SIGHUP})
        if (!isIgnored(signal)) handle(signal, handler);
}

} // namespace

void exitOnInterrupt() {
    handleInterrupts(exitNow);
    handle(SIGPIPE, exitNow);
}

void catchInterrupts() {
    handleInterrupts(onInterrupt);
    handle(SIGPIPE, SIG_IGN);
}

bool interrupted() {
    return stopRequested.load() != 0;
}

int interruptStatus() {
    return statusOf(stopRequested.load());
}

} // namespace dirt
