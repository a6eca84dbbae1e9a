// The pictures of the factory presets' instruments, for lists.
#pragma once

#include "Editor/PresetShelf.h"

#include <juce_graphics/juce_graphics.h>
#include <map>
#include <string>
#include <string_view>

namespace idiophone {

/// Returns the embedded PNG of a factory preset, or nothing. docs/make_preset_pictures.sh makes
/// them.
std::string_view presetPictureFile(const std::string& presetName);

/// For the message thread.
class PresetPictures {
public:
    /// In pixels; all pictures have it.
    static constexpr int width = 192, height = 128;

    /// Draws the preset's picture with round corners, or a plain glyph in this colour if it has
    /// none: only factory presets have one.
    void draw(juce::Graphics& g,
              juce::Rectangle<float> area,
              const ShelvedPreset& preset,
              juce::Colour glyph);

private:
    const juce::Image& pictureOf(const ShelvedPreset& preset);

    std::map<std::string, juce::Image> read; ///< by name
};

} // namespace idiophone
