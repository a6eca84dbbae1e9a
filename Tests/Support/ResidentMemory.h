// Measures the memory of this process.
#pragma once

#include <fstream>
#include <string>

namespace idiophone::test {

/// [KiB] Resident memory of this process, 0 where the system does not report it.
inline double residentKibibytes() {
    std::ifstream file("/proc/self/status");
    double kibibytes = 0;
    for (std::string word; file >> word;)
        if (word == "VmRSS:")
            return file >> kibibytes ? kibibytes : 0;
    return 0;
}

} // namespace idiophone::test
