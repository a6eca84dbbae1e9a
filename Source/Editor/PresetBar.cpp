#include "Editor/PresetBar.h"

#include "Editor/Look.h"

namespace idiophone {

PresetBar::PresetBar(ProcessorView& processor) : view(processor) {
    int id = 1;
    for (const auto& name : view.presetNames())
        list.addItem(juce::String::fromUTF8(name.c_str()), id++);
    list.setTitle("Preset");
    list.setTooltip("Factory presets");
    list.setTextWhenNothingSelected("From the project");
    list.onChange = [this] { view.choosePreset(list.getSelectedId() - 1); };
    previous.setTitle("Previous preset");
    previous.setTooltip("Previous preset");
    previous.onClick = [this] { step(-1); };
    next.setTitle("Next preset");
    next.setTooltip("Next preset");
    next.onClick = [this] { step(1); };
    for (auto* child : std::initializer_list<juce::Component*>{&previous, &list, &next})
        addAndMakeVisible(child);
    refresh();
}

void PresetBar::step(int by) {
    const int count = list.getNumItems();
    if (count > 0)
        view.choosePreset((juce::jmax(view.presetIndex(), 0) + by + count) % count);
    refresh();
}

void PresetBar::refresh() {
    if (const int id = view.presetIndex() + 1; id != list.getSelectedId())
        list.setSelectedId(id, juce::dontSendNotification);
}

void PresetBar::paint(juce::Graphics& g) {
    g.setColour(colourOf(*this, LookColour::accent));
    g.setFont(Look::headingFont(21));
    g.drawText("Idiophone", getLocalBounds(), juce::Justification::centredLeft);
}

void PresetBar::resized() {
    auto area = getLocalBounds().reduced(0, 8);
    area = area.removeFromRight(juce::jmin(420, area.getWidth() * 3 / 5));
    previous.setBounds(area.removeFromLeft(32));
    next.setBounds(area.removeFromRight(32));
    list.setBounds(area.reduced(6, 0));
}

} // namespace idiophone
