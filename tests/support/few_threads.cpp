// Loaded before a program's libraries (LD_PRELOAD): no more than DIRT_TEST_THREADS threads can be
// there at once besides the first, as under a limit on processes, which root would not have.

#include <atomic>
#include <cerrno>
#include <cstdlib>

#include <dlfcn.h>
#include <pthread.h>

namespace {

std::atomic<int> there{0};

struct Start {
    void* (*run)(void*);
    void* argument;
};

struct Leave {
    ~Leave() { --there; }
};

void* runAndLeave(void* given) {
    const Start start = *(Start*) given;
    delete (Start*) given;
    const Leave leave;
    return start.run(start.argument);
}

} // namespace

extern "C" int pthread_create(pthread_t* thread, const pthread_attr_t* attributes,
                              void* (*run)(void*), void* argument) {
    using Create = int (*)(pthread_t*, const pthread_attr_t*, void* (*) (void*), void*);
    static const auto create = (Create) dlsym(RTLD_NEXT, "pthread_create");
    const char* most = std::getenv("DIRT_TEST_THREADS");
    if (++there > (most ? std::atoi(most) : 1 << 20)) {
        --there;
        return EAGAIN;
    }
    return create(thread, attributes, runAndLeave, new Start{run, argument});
}
