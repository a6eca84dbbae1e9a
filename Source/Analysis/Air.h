// The air that objects radiate into, at 20 °C and sea level.
#pragma once

namespace idiophone {

inline constexpr double speedOfSoundMetresPerSecond = 343, airDensityKgPerM3 = 1.204;
inline constexpr double airImpedancePaSPerM = speedOfSoundMetresPerSecond * airDensityKgPerM3;

} // namespace idiophone
