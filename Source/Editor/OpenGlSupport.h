// Whether a picture can be drawn with OpenGL. JUCE crashes where the X server has none.
#pragma once

namespace idiophone {

/// Asks the X server once; true elsewhere. Message thread.
bool hasOpenGl();

} // namespace idiophone
