// The mixing loop as the paper has it: every mode, every sample, one complex multiplication
// (Raghuvanshi & Lin 2006, section 4.1), in float, left to the compiler. What we are measured
// against, not what anybody should use.
#pragma once

#include "Synth/ModalPole.h"

#include <cstddef>
#include <span>
#include <vector>

namespace idiophone {

class NaiveBank {
public:
    NaiveBank(std::span<const ModalPole> poles, double sampleRateHz);

    std::size_t size() const { return re.size(); }

    /// Every mode at amplitude 1/size, phase 0.
    void excite();

    /// Adds what all modes sound to `output`.
    void render(std::span<float> output);

private:
    std::vector<float> re, im, stepRe, stepIm;
};

} // namespace idiophone
