// How far an analysis reaches where nobody says otherwise.
#pragma once

namespace idiophone {

/// From the lowest that is heard as a tone to twice the highest that is heard: a material chosen
/// while an object is played moves its modes, from glass to plastic down to 1/4.3 of their
/// frequencies, and there must be some that come down into what is heard.
inline constexpr double lowestAnalysedHz = 20, highestAnalysedHz = 44000;

/// An object with more would take longer than anyone waits, and not sound in real time.
inline constexpr int mostAnalysedModes = 5000;

} // namespace idiophone
