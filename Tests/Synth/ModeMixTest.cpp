#include "Synth/ModeMix.h"

#include "Synth/AlignedVector.h"

#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <random>
#include <vector>

using namespace idiophone;

namespace {

/// The second batch of a bank, with random tables and states, also of modes beyond it.
struct SecondBatch {
    static constexpr std::size_t first = batchModes;
    static constexpr std::size_t end = first + 3 * modeBlock;

    SecondBatch() {
        std::mt19937 random(1);
        std::uniform_real_distribution<float> values(-1, 1);
        for (float& entry : tables)
            entry = values(random);
        for (std::size_t b = 0; b < subBlocks; ++b)
            for (std::size_t place = 0; place < batchModes; ++place) {
                ahead.x[b][place] = values(random);
                ahead.y[b][place] = values(random);
            }
    }

    /// Returns sample k of a mode by the formula of ModalBankKernel.h.
    double sample(std::size_t g, std::size_t k) const {
        const std::size_t b = k / subBlockSamples, place = g - first;
        const float* table = tables.data() + 2 * subBlockSamples * g + k % subBlockSamples;
        return double(table[0]) * double(ahead.x[b][place]) +
               double(table[subBlockSamples]) * double(ahead.y[b][place]);
    }

    AlignedVector<float> tables = AlignedVector<float>(2 * subBlockSamples * (end + modeBlock));
    SubBlockStates ahead{};
};

} // namespace

TEST_CASE("A batch mixes those modes of runs that lie in it") {
    SecondBatch second;
    const std::vector<ModeRun> runs{{10, 5},
                                    {SecondBatch::first - 3, 5},
                                    {SecondBatch::first + 9, 1},
                                    {SecondBatch::end - 2, 9}};
    for (const std::size_t blocks : {1u, 4u}) {
        const MixBatch batch{second.tables.data(), SecondBatch::first, SecondBatch::end, blocks};
        alignas(64) std::array<float, cellSize> output;
        output.fill(0.5f);
        batch.mix(runs, second.ahead, output.data());
        for (std::size_t k = 0; k < cellSize; ++k) {
            double expected = 0.5;
            for (const std::size_t place : {0u, 1u, 9u, 46u, 47u})
                expected +=
                    k < blocks * subBlockSamples ? second.sample(SecondBatch::first + place, k) : 0;
            CHECK(std::abs(double(output[k]) - expected) < 5e-6);
        }
    }
}

TEST_CASE("A batch mixes the share of each part that lies in it") {
    SecondBatch second;
    const SecondBatch before = second;
    const std::vector<ModePart> parts{{3, 1},
                                      {SecondBatch::first + 2, 0.25f},
                                      {SecondBatch::first + 40, -0.5f},
                                      {SecondBatch::end, 1}};
    const MixBatch batch{second.tables.data(), SecondBatch::first, SecondBatch::end, subBlocks};
    alignas(64) std::array<float, cellSize> output{};
    batch.mix(parts, second.ahead, output.data());
    for (std::size_t k = 0; k < cellSize; ++k) {
        const double expected = 0.25 * before.sample(SecondBatch::first + 2, k) -
                                0.5 * before.sample(SecondBatch::first + 40, k);
        CHECK(std::abs(double(output[k]) - expected) < 5e-6);
    }
}
