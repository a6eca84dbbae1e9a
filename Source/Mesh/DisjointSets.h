// SPDX-License-Identifier: Apache-2.0
// Disjoint sets that can be joined (union-find).
#pragma once

#include <numeric>
#include <utility>
#include <vector>

namespace idiophone {

/// The members are 0 … count − 1, at first each in its own set. The name of a set is its lowest
/// member.
class DisjointSets {
public:
    explicit DisjointSets(std::size_t count) : parents(count) {
        std::iota(parents.begin(), parents.end(), 0);
    }

    int nameOf(int member) {
        while (parents[member] != member) {
            parents[member] = parents[parents[member]];
            member = parents[member];
        }
        return member;
    }

    void join(int one, int other) {
        int low = nameOf(one), high = nameOf(other);
        if (high < low)
            std::swap(low, high);
        parents[high] = low;
    }

private:
    std::vector<int> parents;
};

} // namespace idiophone
