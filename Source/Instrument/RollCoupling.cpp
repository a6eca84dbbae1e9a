#include "Instrument/RollCoupling.h"

#include "Synth/ModalPole.h"

#include <numbers>

namespace idiophone {
namespace {

constexpr double lowestHz = 20;

} // namespace

CoupledModes coupledModes(const LowestModes& lowestModes,
                          const Material& own,
                          const SynthesisSettings& settings) {
    const double ratio = liveFrequencyRatio(own, settings);
    const PoleLaw law{.eigenvalueRatio = ratio * ratio,
                      .fluidDampingPerSecond = settings.material
                                                   ? settings.material->fluidDampingPerSecond
                                                   : own.fluidDampingPerSecond,
                      .viscoelasticDampingSeconds =
                          settings.material ? settings.material->viscoelasticDampingSeconds
                                            : own.viscoelasticDampingSeconds};
    static_assert(LowestModes::capacity <= ContactForce::maxCoupledModes);
    CoupledModes result;
    for (const double referenceHz : lowestModes.span()) {
        const double omega = 2 * std::numbers::pi * referenceHz;
        const auto pole = law.pole(omega * omega);
        if (naturalFrequencyHz(pole) >= lowestHz && isOscillating(pole))
            result.add({.frequencyHz = dampedFrequency(pole) / (2 * std::numbers::pi),
                        .dampingPerSecond = pole.damping / 2});
    }
    return result;
}

} // namespace idiophone
