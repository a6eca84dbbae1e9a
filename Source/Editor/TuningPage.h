// The page of the tuning: a scale from a file or the session, concert pitch, and bend ranges.
#pragma once

#include "Editor/DeckPage.h"
#include "Editor/FileButton.h"
#include "Editor/Look.h"
#include "Editor/ParameterColumns.h"
#include "Editor/Utf8.h"

#include <utility>
#include <vector>

namespace idiophone {

class TuningPage final : public DeckPage {
public:
    explicit TuningPage(ProcessorView& processor)
        : DeckPage("Tuning"), view(processor),
          open("Open...",
               "Open a scale or a keyboard mapping",
               "Open a Scala scale (.scl) or a keyboard mapping (.kbm). Dropping it on the "
               "window does the same.",
               fromUtf8(processor.tuning.tuningPatterns()),
               [this](const std::filesystem::path& file) {
                   view.tuning.openTuning(file);
                   refresh();
               }),
          columns(groups(), processor) {
        addButton(forget, "Forget the tuning",
                  "Forget the scale and the mapping, or else the tuning by MIDI messages. The keys "
                  "follow "
                  "the session, or equal temperament.",
                  [this] { view.tuning.forgetTuning(); });
        scale.setFont(Look::headingFont());
        scale.setTitle("Scale");
        origin.setTitle("Where the tuning comes from");
        showParts(*this, open, scale, origin, columns);
        shown = view.tuning.tuningStatus();
        lookAndFeelChanged();
        showTuning();
    }

    void refresh() override {
        columns.refresh();
        auto status = view.tuning.tuningStatus();
        if (status == shown)
            return;
        shown = std::move(status);
        showTuning();
    }
    void resized() override {
        auto area = getLocalBounds().reduced(padding);
        auto row = area.removeFromTop(scaleHeight);
        forget.setBounds(row.removeFromRight(buttonWidth));
        row.removeFromRight(gap);
        open.setBounds(row.removeFromRight(buttonWidth));
        row.removeFromRight(gap);
        scale.setBounds(row);
        origin.setBounds(area.removeFromTop(originHeight));
        area.removeFromTop(2 * gap);
        columns.setBounds(area);
    }
    void lookAndFeelChanged() override {
        scale.setColour(juce::Label::textColourId, colourOf(*this, LookColour::text));
        origin.setColour(juce::Label::textColourId, colourOf(*this, LookColour::dimText));
    }

private:
    using Source = TuningStatus::Source;

    static constexpr int scaleHeight = 26, originHeight = 20, buttonWidth = 70, gap = 6;

    static std::vector<ParameterGroup> groups() { return {{"Pitch", 0}, {"MPE", 1}}; }

    static juce::String originOf(const TuningStatus& status) {
        switch (status.source) {
        case Source::files:
            return status.mappingFile.empty() ? juce::String("A scale of your own, from note 60 on")
                                              : "Keys as in " + fromUtf8(status.mappingFile);
        case Source::session:
            return "Tuning of the session (MTS-ESP)";
        case Source::messages:
            return "Messages of the MIDI Tuning Standard";
        default:
            return "Open or drop a scale (.scl) or a mapping (.kbm)";
        }
    }

    void showTuning() {
        const auto name = fromUtf8(shown.scale);
        scale.setText(name.isEmpty() ? juce::String("A scale without a name") : name,
                      juce::dontSendNotification);
        scale.setTooltip(name);
        origin.setText(originOf(shown), juce::dontSendNotification);
        forget.setEnabled(shown.source == Source::files || shown.source == Source::messages);
    }

    ProcessorView& view;
    TuningStatus shown;
    TextLabel scale, origin;
    FileButton open;
    juce::TextButton forget{"Forget"};
    ParameterColumns columns;
};

} // namespace idiophone
