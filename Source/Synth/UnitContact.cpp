// SPDX-License-Identifier: Apache-2.0
#include "Synth/UnitContact.h"

#include "Synth/ModePoles.h"
#include "Synth/StrikeKernel.h"

#include <algorithm>

namespace idiophone {

void UnitContact::setForced(const ModePoles& poles, const PulseInstant& pulse) noexcept {
    forcedStates(pulse, poles.arrays(), poles.paddedSize(), *this);
    poles.heavy().setForced(pulse, *this);
}

void UnitContact::setImpulse(const ModePoles& poles) noexcept {
    std::fill_n(x.begin(), poles.paddedSize(), 1.0f);
    const auto& shares = poles.arrays().velocityShare;
    for (std::size_t g = 0; g < poles.paddedSize(); ++g)
        y[g] = static_cast<float>(shares[g]);
}

} // namespace idiophone
