// Checks for OpenGL, because JUCE crashes if the X server has none.
#pragma once

namespace idiophone {

/// Whether OpenGL is available. Asks the X server once; always true on other systems. Message
/// thread.
bool hasOpenGl();

} // namespace idiophone
