// The picture where there is no OpenGL: flat faces from back to front.
#pragma once

#include "Editor/SceneFrame.h"

#include <juce_gui_basics/juce_gui_basics.h>

namespace idiophone {

/// Paints the objects of a frame over an area. Objects with many faces are painted as their
/// bounding boxes. Without furniture, mallets, light and motion.
void paintPlainPicture(juce::Graphics& g, juce::Rectangle<float> area, const SceneFrame& frame);

} // namespace idiophone
