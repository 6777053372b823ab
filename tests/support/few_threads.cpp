// Loaded before a program's libraries (LD_PRELOAD): of the threads that it makes, only the first
// DIRT_TEST_THREADS can be made, as under a limit on processes, which root would not have.

#include <atomic>
#include <cerrno>
#include <cstdlib>

#include <dlfcn.h>
#include <pthread.h>

extern "C" int pthread_create(pthread_t* thread, const pthread_attr_t* attributes,
                              void* (*run)(void*), void* argument) {
    using Create = int (*)(pthread_t*, const pthread_attr_t*, void* (*) (void*), void*);
    static std::atomic<int> made{0};
    static const auto create = (Create) dlsym(RTLD_NEXT, "pthread_create");
    const char* most = std::getenv("DIRT_TEST_THREADS");
    if (most && made++ >= std::atoi(most)) return EAGAIN;
    return create(thread, attributes, run, argument);
}
