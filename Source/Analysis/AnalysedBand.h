// The default frequency band and mode limit of an analysis.
#pragma once

namespace idiophone {

/// The default band starts at the lowest audible tone and ends at twice the highest audible
/// frequency. A live material change can lower all modes, from glass to plastic to 1/4.3 of their
/// frequencies. The modes above the audible band then become audible.
inline constexpr double lowestAnalysedHz = 20, highestAnalysedHz = 44000;

/// Maximum number of modes. More would take too long to analyse and could not play in real time.
inline constexpr int mostAnalysedModes = 5000;

} // namespace idiophone
