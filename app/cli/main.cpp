#include "app/cli/interrupt.h"
#include "app/cli/program.h"

#include <cstdlib>

#include <signal.h>

int main(int argc, char** argv) {
    dirt::exitOnInterrupt();
    signal(SIGXFSZ, SIG_IGN); // a file that grows beyond its limit is an error like a full disk
    setenv("EGL_LOG_LEVEL", "fatal", 0); // Mesa's: what goes wrong is said once, by us
    return dirt::runProgram(argc, argv);
}
