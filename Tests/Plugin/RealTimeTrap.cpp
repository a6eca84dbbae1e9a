#include "Plugin/RealTimeTrap.h"

#include "Support/Sanitizers.h"

#if defined(__linux__) && defined(__GLIBC__) && !IDIOPHONE_SANITIZED

#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <ctime>
#include <cxxabi.h>
#include <dlfcn.h>
#include <linux/futex.h>
#include <pthread.h>
#include <semaphore.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <ucontext.h>
#include <utility>

// Added in Linux 5.11; older headers lack them.
#ifndef PR_SET_SYSCALL_USER_DISPATCH
#define PR_SET_SYSCALL_USER_DISPATCH 59
#define PR_SYS_DISPATCH_ON 1
#endif

namespace {

struct Watch {
    volatile bool active = false;
    volatile char systemCallsBlocked = 0; ///< read by the kernel at each system call
    bool dispatching = false;
    int allocations = 0, locks = 0, systemCalls = 0, wakes = 0;
    const char* first = nullptr;
    int firstSystemCall = -1;
    std::size_t maximumBytes = SIZE_MAX; ///< limit of one allocation
    bool startsNoThreads = false;
    std::function<void()>* atAllocations = nullptr;
};
thread_local Watch watch;

void note(int Watch::*counter, const char* name) {
    if (!watch.active)
        return;
    ++(watch.*counter);
    if (watch.first == nullptr)
        watch.first = name;
}

void noteAllocation(const char* name) {
    note(&Watch::allocations, name);
    if (auto* each = std::exchange(watch.atAllocations, nullptr)) {
        (*each)();
        watch.atAllocations = each;
    }
}

template <class Function>
Function* next(Function*& function, const char* name) {
    if (function == nullptr)
        function = reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
    return function;
}

template <class Function, class... Arguments>
int lockCall(Function*& function, const char* name, Arguments... arguments) {
    note(&Watch::locks, name);
    return next(function, name)(arguments...);
}

#if defined(__x86_64__)
// Called by the kernel instead of the system call. Counts the call and then repeats it, so that the
// watched code behaves as usual. Sees only the first call of each watch.
void onSystemCall(int, siginfo_t* info, void* context) {
    watch.systemCallsBlocked = 0;
    auto& registers = static_cast<ucontext_t*>(context)->uc_mcontext.gregs;
    if (info->si_syscall == SYS_futex && (registers[REG_RSI] & FUTEX_CMD_MASK) == FUTEX_WAKE) {
        ++watch.wakes;
    } else {
        note(&Watch::systemCalls, "a system call");
        if (watch.firstSystemCall < 0)
            watch.firstSystemCall = info->si_syscall;
    }
    constexpr int systemCallInstructionBytes = 2;
    registers[REG_RIP] -= systemCallInstructionBytes;
    registers[REG_RAX] = info->si_syscall;
}

bool dispatchSystemCalls() {
    if (!watch.dispatching) {
        struct sigaction action {};
        action.sa_sigaction = onSystemCall;
        action.sa_flags = SA_SIGINFO;
        sigaction(SIGSYS, &action, nullptr);
        watch.dispatching = prctl(PR_SET_SYSCALL_USER_DISPATCH, PR_SYS_DISPATCH_ON, 0L, 0L,
                                  &watch.systemCallsBlocked) == 0;
    }
    return watch.dispatching;
}
#else
bool dispatchSystemCalls() {
    return false;
}
#endif

} // namespace

#define IDIOPHONE_WATCHED_LOCK(name, parameters, ...)                                              \
    extern "C" int name parameters {                                                               \
        static decltype(&name) function = nullptr;                                                 \
        return lockCall(function, #name, __VA_ARGS__);                                             \
    }

// The executable's definitions take precedence over the C library's, also for other libraries if
// they are visible to them.
#pragma GCC visibility push(default)
extern "C" {

void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);
void __libc_free(void*);

void* malloc(std::size_t size) {
    noteAllocation("malloc");
    return size > watch.maximumBytes ? nullptr : __libc_malloc(size);
}
void* calloc(std::size_t count, std::size_t size) {
    noteAllocation("calloc");
    return __libc_calloc(count, size);
}
void* realloc(void* block, std::size_t size) {
    noteAllocation("realloc");
    return __libc_realloc(block, size);
}
void* memalign(std::size_t alignment, std::size_t size) {
    noteAllocation("memalign");
    return __libc_memalign(alignment, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
    noteAllocation("aligned_alloc");
    return size > watch.maximumBytes ? nullptr : __libc_memalign(alignment, size);
}
int posix_memalign(void** block, std::size_t alignment, std::size_t size) {
    noteAllocation("posix_memalign");
    *block = size > watch.maximumBytes ? nullptr : __libc_memalign(alignment, size);
    return *block == nullptr ? ENOMEM : 0;
}
void free(void* block) {
    if (block != nullptr) // free(nullptr) does nothing, and is allowed to
        noteAllocation("free");
    __libc_free(block);
}
}

extern "C" int pthread_create(pthread_t* thread,
                              const pthread_attr_t* attributes,
                              void* (*run)(void*),
                              void* argument) {
    static decltype(&pthread_create) function = nullptr;
    return watch.startsNoThreads
               ? EAGAIN
               : next(function, "pthread_create")(thread, attributes, run, argument);
}

using Time = const timespec*;
IDIOPHONE_WATCHED_LOCK(pthread_mutex_lock, (pthread_mutex_t * m), m)
IDIOPHONE_WATCHED_LOCK(pthread_mutex_trylock, (pthread_mutex_t * m), m)
IDIOPHONE_WATCHED_LOCK(pthread_mutex_timedlock, (pthread_mutex_t * m, Time t), m, t)
IDIOPHONE_WATCHED_LOCK(pthread_mutex_clocklock, (pthread_mutex_t * m, clockid_t k, Time t), m, k, t)
IDIOPHONE_WATCHED_LOCK(pthread_rwlock_rdlock, (pthread_rwlock_t * l), l)
IDIOPHONE_WATCHED_LOCK(pthread_rwlock_wrlock, (pthread_rwlock_t * l), l)
IDIOPHONE_WATCHED_LOCK(pthread_rwlock_tryrdlock, (pthread_rwlock_t * l), l)
IDIOPHONE_WATCHED_LOCK(pthread_rwlock_trywrlock, (pthread_rwlock_t * l), l)
IDIOPHONE_WATCHED_LOCK(pthread_rwlock_timedrdlock, (pthread_rwlock_t * l, Time t), l, t)
IDIOPHONE_WATCHED_LOCK(pthread_rwlock_timedwrlock, (pthread_rwlock_t * l, Time t), l, t)
IDIOPHONE_WATCHED_LOCK(
    pthread_rwlock_clockrdlock, (pthread_rwlock_t * l, clockid_t k, Time t), l, k, t)
IDIOPHONE_WATCHED_LOCK(
    pthread_rwlock_clockwrlock, (pthread_rwlock_t * l, clockid_t k, Time t), l, k, t)
IDIOPHONE_WATCHED_LOCK(pthread_spin_lock, (pthread_spinlock_t * l), l)
IDIOPHONE_WATCHED_LOCK(pthread_spin_trylock, (pthread_spinlock_t * l), l)
IDIOPHONE_WATCHED_LOCK(pthread_cond_wait, (pthread_cond_t * c, pthread_mutex_t* m), c, m)
IDIOPHONE_WATCHED_LOCK(
    pthread_cond_timedwait, (pthread_cond_t * c, pthread_mutex_t* m, Time t), c, m, t)
IDIOPHONE_WATCHED_LOCK(pthread_cond_clockwait,
                       (pthread_cond_t * c, pthread_mutex_t* m, clockid_t k, Time t),
                       c,
                       m,
                       k,
                       t)
IDIOPHONE_WATCHED_LOCK(pthread_cond_signal, (pthread_cond_t * c), c)
IDIOPHONE_WATCHED_LOCK(pthread_cond_broadcast, (pthread_cond_t * c), c)
IDIOPHONE_WATCHED_LOCK(pthread_barrier_wait, (pthread_barrier_t * b), b)
IDIOPHONE_WATCHED_LOCK(pthread_once, (pthread_once_t * o, void (*f)()), o, f)
IDIOPHONE_WATCHED_LOCK(sem_wait, (sem_t * s), s)
IDIOPHONE_WATCHED_LOCK(sem_trywait, (sem_t * s), s)
IDIOPHONE_WATCHED_LOCK(sem_timedwait, (sem_t * s, Time t), s, t)
IDIOPHONE_WATCHED_LOCK(sem_clockwait, (sem_t * s, clockid_t k, Time t), s, k, t)
IDIOPHONE_WATCHED_LOCK(sem_post, (sem_t * s), s)

// Called at the first use of a function's static variable, which is guarded by a lock. Standard
// libraries have different types of guards.
template <class Argument>
Argument argumentOf(int (*)(Argument));
using Guard = decltype(argumentOf(__cxxabiv1::__cxa_guard_acquire));
extern "C" int __cxxabiv1::__cxa_guard_acquire(Guard guard) {
    static int (*function)(Guard) = nullptr;
    return lockCall(function, "__cxa_guard_acquire", guard);
}

#pragma GCC visibility pop

namespace idiophone::test {

bool realTimeTrapWorks() {
    return true;
}

bool systemCallTrapWorks() {
    return dispatchSystemCalls();
}

void beginRealTimeWatch() {
    const bool blocks = dispatchSystemCalls();
    watch.allocations = watch.locks = watch.systemCalls = watch.wakes = 0;
    watch.first = nullptr;
    watch.firstSystemCall = -1;
    watch.active = true;
    watch.systemCallsBlocked = blocks ? 1 : 0;
}

RealTimeFaults endRealTimeWatch() {
    watch.systemCallsBlocked = 0;
    watch.active = false;
    RealTimeFaults faults{.allocations = watch.allocations,
                          .locks = watch.locks,
                          .systemCalls = watch.systemCalls,
                          .wakes = watch.wakes,
                          .first = watch.first == nullptr ? "" : watch.first};
    if (watch.firstSystemCall >= 0)
        faults.first += " (system call " + std::to_string(watch.firstSystemCall) + ")";
    return faults;
}

MemoryLimit::MemoryLimit(std::size_t maximumBytes) {
    watch.maximumBytes = maximumBytes;
}

MemoryLimit::~MemoryLimit() {
    watch.maximumBytes = SIZE_MAX;
}

NoThreads::NoThreads() {
    watch.startsNoThreads = true;
}

NoThreads::~NoThreads() {
    watch.startsNoThreads = false;
}

AtAllocations::AtAllocations(std::function<void()> each) : called(std::move(each)) {
    watch.atAllocations = &called;
}

AtAllocations::~AtAllocations() {
    watch.atAllocations = nullptr;
}

} // namespace idiophone::test

#else

namespace idiophone::test {

bool realTimeTrapWorks() {
    return false;
}
bool systemCallTrapWorks() {
    return false;
}
void beginRealTimeWatch() {}
RealTimeFaults endRealTimeWatch() {
    return {};
}
MemoryLimit::MemoryLimit(std::size_t) {}
MemoryLimit::~MemoryLimit() {}
NoThreads::NoThreads() {}
NoThreads::~NoThreads() {}
AtAllocations::AtAllocations(std::function<void()>) {}
AtAllocations::~AtAllocations() {}

} // namespace idiophone::test

#endif
