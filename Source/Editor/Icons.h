// The icons of buttons, as paths in a square from 0 to 1.
#pragma once

#include <juce_graphics/juce_graphics.h>

namespace idiophone::icons {

juce::Path previous();
juce::Path next();
juce::Path star();
juce::Path starOutline();
juce::Path save();
juce::Path dice();
juce::Path undo();
juce::Path redo();
juce::Path copy();
juce::Path silence();
juce::Path soundFile();
juce::Path record();
juce::Path samples();
juce::Path frame();
juce::Path folder();
juce::Path sheet();
juce::Path close();
juce::Path minimise();

} // namespace idiophone::icons
