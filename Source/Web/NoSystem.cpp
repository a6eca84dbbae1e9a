// SPDX-License-Identifier: Apache-2.0
// Answers the calls of the C and C++ libraries to a system (WASI), so that the module imports
// nothing and every host can load it. There are no files and no environment. An ended program is a
// trap.
#include <cstdint>

namespace {
constexpr std::int32_t done = 0, notSupported = 58;
}

extern "C" {

std::int32_t __imported_wasi_snapshot_preview1_environ_sizes_get(std::int32_t* count,
                                                                 std::int32_t* bytes) {
    *count = *bytes = 0;
    return done;
}

std::int32_t __imported_wasi_snapshot_preview1_environ_get(std::int32_t, std::int32_t) {
    return done;
}

std::int32_t __imported_wasi_snapshot_preview1_fd_close(std::int32_t) {
    return notSupported;
}

std::int32_t
__imported_wasi_snapshot_preview1_fd_seek(std::int32_t, std::int64_t, std::int32_t, std::int32_t) {
    return notSupported;
}

std::int32_t
__imported_wasi_snapshot_preview1_fd_write(std::int32_t, std::int32_t, std::int32_t, std::int32_t) {
    return notSupported;
}

[[noreturn]] void __imported_wasi_snapshot_preview1_proc_exit(std::int32_t) {
    __builtin_trap();
}

/// Registers what is destroyed when a thread ends. The only one never does.
int __cxa_thread_atexit(void (*)(void*), void*, void*) {
    return 0;
}

} // extern "C"
