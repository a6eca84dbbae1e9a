// Draws random numbers, the same ones on every platform from the same seed.
#pragma once

#include <cstdint>
#include <random>

namespace idiophone::test {

class Chance {
public:
    void seed(std::uint64_t seed) { random.seed(static_cast<std::mt19937::result_type>(seed)); }
    /// Returns a number from 0 to count − 1.
    int below(int count) { return static_cast<int>(random() % static_cast<unsigned>(count)); }
    /// Returns a number from 0 to below 1.
    double share() { return static_cast<double>(random()) / 4294967296.0; }

private:
    std::mt19937 random;
};

} // namespace idiophone::test
