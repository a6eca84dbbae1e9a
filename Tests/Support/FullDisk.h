// Simulates a full disk: limits the size of each file that this process writes, while the object
// lives. Not for Windows, which has no such limit.
#pragma once

#ifndef _WIN32

#include <csignal>
#include <sys/resource.h>

namespace idiophone::test {

/// Make no assertion meanwhile: the test's own output may be a file.
class FullDisk {
public:
    explicit FullDisk(rlim_t bytesOfFile) : signalBefore(std::signal(SIGXFSZ, SIG_IGN)) {
        getrlimit(RLIMIT_FSIZE, &before);
        const rlimit full{.rlim_cur = bytesOfFile, .rlim_max = before.rlim_max};
        setrlimit(RLIMIT_FSIZE, &full);
    }
    ~FullDisk() {
        setrlimit(RLIMIT_FSIZE, &before);
        std::signal(SIGXFSZ, signalBefore);
    }
    FullDisk(const FullDisk&) = delete;
    FullDisk& operator=(const FullDisk&) = delete;

private:
    void (*signalBefore)(int);
    rlimit before{};
};

} // namespace idiophone::test

#endif
