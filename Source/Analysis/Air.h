// The air that objects radiate into: 20 °C at sea level.
#pragma once

namespace idiophone {

inline constexpr double speedOfSoundMetresPerSecond = 343, airDensityKgPerM3 = 1.204;

} // namespace idiophone
