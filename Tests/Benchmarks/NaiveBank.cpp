#include "Benchmarks/NaiveBank.h"

#include <algorithm>
#include <cmath>

namespace idiophone {

NaiveBank::NaiveBank(std::span<const ModalPole> poles, double sampleRateHz)
    : re(poles.size()), im(poles.size()) {
    for (const ModalPole& pole : poles) {
        const double size = std::exp(-pole.damping / 2 / sampleRateHz);
        const double angle = dampedFrequency(pole) / sampleRateHz;
        stepRe.push_back(static_cast<float>(size * std::cos(angle)));
        stepIm.push_back(static_cast<float>(size * std::sin(angle)));
    }
}

void NaiveBank::excite() {
    std::fill(re.begin(), re.end(), 1 / static_cast<float>(size()));
    std::fill(im.begin(), im.end(), 0.0f);
}

void NaiveBank::render(std::span<float> output) {
    const std::size_t modes = size();
    float* const x = re.data();
    float* const y = im.data();
    const float* const c = stepRe.data();
    const float* const s = stepIm.data();
    for (float& sample : output) {
        float sum = 0;
        for (std::size_t i = 0; i < modes; ++i) {
            sum += x[i];
            const float turned = c[i] * x[i] - s[i] * y[i];
            y[i] = c[i] * y[i] + s[i] * x[i];
            x[i] = turned;
        }
        sample += sum;
    }
}

} // namespace idiophone
