// The mixing loop of the paper: one complex multiplication in float for every mode and sample,
// without manual optimisation (Raghuvanshi & Lin 2006, section 4.1). A reference for measurements,
// not for use.
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

    /// Sets every mode to amplitude 1/size, phase 0.
    void excite();

    /// Adds the sound of all modes to `output`.
    void render(std::span<float> output);

private:
    std::vector<float> re, im, stepRe, stepIm;
};

} // namespace idiophone
