#include "Synth/ModalBankKernel.h"

namespace idiophone {

namespace {

// Summed in the output itself and not in a local array, which gcc 12 takes apart into scalars.
void renderSubBlock(const ModalBankArrays& bank,
                    std::span<const std::int32_t> active,
                    float* __restrict output) noexcept {
    for (const std::int32_t index : active) {
        const auto g = static_cast<std::size_t>(index);
        double* state = bank.states + 2 * g;
        const double* step = bank.steps + 4 * g;
        const float* __restrict table = bank.tables + 2 * subBlockSamples * g;
        const double x = state[0];
        const double y = state[1];
        const auto xf = static_cast<float>(x);
        const auto yf = static_cast<float>(y);
        for (std::size_t k = 0; k < subBlockSamples; ++k)
            output[k] += table[k] * xf + table[subBlockSamples + k] * yf;
        state[0] = step[0] * x + step[1] * y;
        state[1] = step[2] * x + step[3] * y;
    }
}

} // namespace

void renderModalBank(const ModalBankArrays& bank,
                     std::span<const std::int32_t> active,
                     std::span<float> output) noexcept {
    for (std::size_t start = 0; start + subBlockSamples <= output.size(); start += subBlockSamples)
        renderSubBlock(bank, active, output.data() + start);
}

} // namespace idiophone
