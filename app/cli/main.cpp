#include "app/cli/interrupt.h"
#include "app/cli/program.h"

#include <signal.h>

int main(int argc, char** argv) {
    dirt::exitOnInterrupt();
    signal(SIGXFSZ, SIG_IGN); // a file that grows beyond its limit is an error like a full disk
    return dirt::runProgram(argc, argv);
}
