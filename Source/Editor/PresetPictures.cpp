#include "Editor/PresetPictures.h"

#include "Object/EmbeddedFiles.h"

#include <span>

namespace idiophone {

std::span<const EmbeddedFile> pictureFiles(); // generated

namespace {

constexpr float cornerSize = 4;

/// "Falling Rings" is in falling-rings.png.
std::string fileName(const std::string& presetName) {
    std::string name;
    for (const char letter : presetName)
        name += juce::CharacterFunctions::isLetterOrDigit(letter)
                    ? static_cast<char>(juce::CharacterFunctions::toLowerCase(letter))
                    : '-';
    return name + ".png";
}

/// Three bars of a keyboard.
void drawGlyph(juce::Graphics& g, juce::Rectangle<float> area) {
    const auto bars = area.withSizeKeepingCentre(area.getHeight() * 0.6f, area.getHeight() * 0.5f);
    const float step = bars.getWidth() / 3;
    for (int i = 0; i < 3; ++i)
        g.fillRoundedRectangle(bars.withWidth(step * 0.75f)
                                   .translated(step * static_cast<float>(i), 0)
                                   .reduced(0, bars.getHeight() * 0.12f * static_cast<float>(i)),
                               2);
}

} // namespace

std::string_view presetPictureFile(const std::string& presetName) {
    const auto* file = findNamed(pictureFiles(), fileName(presetName));
    return file != nullptr ? file->bytes : std::string_view();
}

const juce::Image& PresetPictures::pictureOf(const ShelvedPreset& preset) {
    auto& picture = read[preset.name];
    if (picture.isNull())
        if (const auto file = presetPictureFile(preset.name); !file.empty())
            picture = juce::ImageFileFormat::loadFrom(file.data(), file.size());
    return picture;
}

void PresetPictures::draw(juce::Graphics& g,
                          juce::Rectangle<float> area,
                          const ShelvedPreset& preset,
                          juce::Colour glyph) {
    const auto picture = preset.isFactory ? pictureOf(preset) : juce::Image();
    if (picture.isNull()) {
        g.setColour(glyph);
        g.drawRoundedRectangle(area.reduced(0.5f), cornerSize, 1);
        return drawGlyph(g, area);
    }
    const juce::Graphics::ScopedSaveState saved(g);
    juce::Path frame;
    frame.addRoundedRectangle(area, cornerSize);
    g.reduceClipRegion(frame);
    g.setImageResamplingQuality(juce::Graphics::highResamplingQuality);
    g.drawImage(picture, area);
}

} // namespace idiophone
