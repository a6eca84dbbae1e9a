// A disk that has room for so many bytes of each file, for this process and while it lives. Windows
// has no such limit.
#pragma once

#ifndef _WIN32

#include <csignal>
#include <sys/resource.h>

namespace idiophone::test {

/// Let nothing be reported meanwhile: the test's own output may be a file.
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
