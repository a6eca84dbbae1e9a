// SPDX-License-Identifier: Apache-2.0
// A team of one: WebAssembly has no threads.
#include "Object/WorkTeam.h"

namespace idiophone {

struct WorkTeam::Threads {};

WorkTeam::WorkTeam(unsigned, unsigned) {}

WorkTeam::~WorkTeam() = default;

void WorkTeam::runBoth(const std::function<void()>& other, const std::function<void()>& own) {
    other();
    own();
}

void WorkTeam::runAll(std::size_t count, const Item& handle) {
    for (std::size_t item = 0; item < count; ++item)
        handle(item, 0);
}

std::size_t WorkTeam::threadCount() const {
    return 1;
}

WorkTeam::Turn::Turn(WorkTeam* onlyTeam) : team(onlyTeam) {}

WorkTeam::Turn::~Turn() = default;

} // namespace idiophone
