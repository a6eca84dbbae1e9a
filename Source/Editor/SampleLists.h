// The choices of an export of samples as two columns of lists: what is struck, and its files.
#pragma once

#include "Editor/Look.h"
#include "Editor/ModeText.h"
#include "Editor/ProcessorView.h"

#include <array>
#include <functional>
#include <initializer_list>
#include <juce_gui_basics/juce_gui_basics.h>
#include <span>
#include <string_view>

namespace idiophone {

/// Needs at least 640 x `height` pixels.
class SampleLists final : public juce::Component {
public:
    static constexpr int height = 6 * 26 + 5 * 5;

    explicit SampleLists(InstrumentView& instrumentView) : view(instrumentView) {
        int order = 0;
        for (auto& [list, label] : fields) {
            const auto& row = rows[static_cast<std::size_t>(order)];
            label.setText(row.label, juce::dontSendNotification);
            label.setAccessible(false);
            label.setInterceptsMouseClicks(false, false);
            list.setTitle(row.title);
            list.setTooltip(row.tooltip);
            list.setExplicitFocusOrder(++order);
            list.onChange = [this] {
                showSource();
                juce::NullCheckedInvocation::invoke(onChange);
            };
            addAndMakeVisible(label);
            addAndMakeVisible(list);
        }
        fillNumbers();
        followInstrument();
        showSource();
    }

    std::function<void()> onChange;

    SampleSettings settings() const {
        SampleSettings chosen;
        chosen.source =
            isOfPlaces() ? SampleSettings::Source::places : SampleSettings::Source::keys;
        chosen.lowestKey = number(lowest) - 1;
        chosen.highestKey = number(highest) - 1;
        chosen.every = number(every);
        chosen.object = static_cast<std::size_t>(number(object) - 1);
        chosen.places = number(places);
        chosen.velocities = number(velocities);
        chosen.roundRobins = number(roundRobins);
        chosen.isFlac = number(format) == flacId;
        chosen.bitDepth = number(bits);
        chosen.sampleRateHz = number(rate);
        chosen.tailDecibels = -number(tail);
        chosen.longestSeconds = number(longest);
        return chosen;
    }

    /// Lists the keys and objects of another instrument, if one plays.
    void followInstrument() {
        if (view.instrumentNumber() == instrument)
            return;
        instrument = view.instrumentNumber();
        fillKeys();
        list(object).clear(juce::dontSendNotification);
        int id = 0;
        for (const auto& played : view.playedObjects())
            list(object).addItem(objectText(played), ++id);
        list(object).setSelectedId(1, juce::dontSendNotification);
    }

    void resized() override {
        constexpr int rowHeight = 26, gap = 5, columnGap = 24;
        const int width = (getWidth() - columnGap) / 2;
        std::array columns{getLocalBounds().removeFromLeft(width),
                           getLocalBounds().removeFromRight(width)};
        for (std::size_t i = 0; i < fields.size(); ++i) {
            auto& [list, label] = fields[i];
            if (!list.isVisible())
                continue;
            auto& column = columns[i < format ? 0 : 1];
            auto row = column.removeFromTop(rowHeight);
            column.removeFromTop(gap);
            label.setBounds(row.removeFromLeft(labelWidth));
            list.setBounds(row);
        }
    }

private:
    enum Place {
        source,
        lowest,
        highest,
        every,
        object,
        places,
        velocities,
        roundRobins,
        format, // from here on in the second column
        bits,
        rate,
        tail,
        longest,
        count
    };
    struct Row {
        const char *label, *title, *tooltip;
    };
    static constexpr std::array<Row, count> rows{
        {{"Strike", "What to sample",
          "The keys of the instrument for a sampler, or places of one object for a game"},
         {"From", "Lowest key", "The lowest key to sample"},
         {"To", "Highest key", "The highest key to sample"},
         {"Sample", "Which keys", "The other keys play the nearest sample at their own pitch"},
         {"Object", "Object to sample", "The object that is struck"},
         {"Places", "Number of places", "Places spread evenly over the object"},
         {"Velocities", "Velocity layers", "How many strengths of a strike each key or place has"},
         {"Round robins", "Round robins",
          "Different strikes that take turns; they differ by Spread and Chatter"},
         {"Format", "File format", "FLAC files are smaller and lose nothing"},
         {"Bits", "Bits", "Bits of each number in the files"},
         {"Sample rate", "Rate of the samples", "Sample rate of the files"},
         {"End at", "Level at the end",
          "A sample ends where it has fallen this far below its peak"},
         {"At most", "Longest sample", "A sample that still rings then is cut"}}};
    static constexpr int labelWidth = 96;
    static constexpr int keysId = 1, placesId = 2, wavId = 1, flacId = 2;

    struct Field {
        juce::ComboBox list;
        TextLabel label;
    };

    juce::ComboBox& list(Place place) { return fields[place].list; }
    /// Each item's ID is its number.
    int number(Place place) const { return fields[place].list.getSelectedId(); }
    bool isOfPlaces() const { return number(source) == placesId; }

    void fill(Place place,
              std::initializer_list<int> numbers,
              int chosen,
              const juce::String& unit = {},
              const juce::String& sign = {}) {
        for (const int each : numbers)
            list(place).addItem(sign + juce::String(each) + unit, each);
        list(place).setSelectedId(chosen, juce::dontSendNotification);
    }
    void fillNumbers() {
        const SampleSettings first;
        list(source).addItem("The keys of the instrument", keysId);
        list(source).addItem("Places of one object", placesId);
        list(source).setSelectedId(keysId, juce::dontSendNotification);
        list(every).addItem("Every key", 1);
        for (const int each : {2, 3, 4, 5, 6, 12})
            list(every).addItem("One key in " + juce::String(each), each);
        list(every).setSelectedId(first.every, juce::dontSendNotification);
        fill(places, {1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 100}, first.places);
        fill(velocities, {1, 2, 3, 4, 5, 6, 8, 10, 12, 16, 24, 32, 64, 127}, first.velocities);
        fill(roundRobins, {1, 2, 3, 4, 5, 6, 8, 10}, first.roundRobins);
        list(format).addItem("WAV", wavId);
        list(format).addItem("FLAC", flacId);
        list(format).setSelectedId(wavId, juce::dontSendNotification);
        fill(bits, {16, 24}, first.bitDepth);
        fill(rate, {44100, 48000, 88200, 96000, 176400, 192000}, first.sampleRateHz, " Hz");
        fill(tail, {30, 40, 50, 60, 70, 80, 90, 100, 120}, -first.tailDecibels, " dB", "-");
        fill(longest, {1, 2, 5, 10, 20, 30, 60, 120, 300, 600}, first.longestSeconds, " s");
    }
    /// Chooses the keys with objects of their own.
    void fillKeys() {
        const auto sounds = view.keySounds();
        int first = 0, last = 0;
        for (auto* keys : {&list(lowest), &list(highest)})
            keys->clear(juce::dontSendNotification);
        for (int key = 0; key < static_cast<int>(sounds.size()); ++key) {
            const auto sound = sounds[static_cast<std::size_t>(key)];
            if (sound == InstrumentView::KeySound::silent)
                continue;
            const int id = key + 1;
            for (auto* keys : {&list(lowest), &list(highest)})
                keys->addItem(noteName(key) + " (" + juce::String(key) + ")", id);
            if (sound != InstrumentView::KeySound::own)
                continue;
            first = first == 0 ? id : first;
            last = id;
        }
        list(lowest).setSelectedId(first, juce::dontSendNotification);
        list(highest).setSelectedId(last, juce::dontSendNotification);
    }
    void showSource() {
        for (const auto place : {lowest, highest, every, roundRobins})
            showField(place, !isOfPlaces());
        for (const auto place : {object, places})
            showField(place, isOfPlaces());
        resized();
    }
    void showField(Place place, bool isShown) {
        fields[place].list.setVisible(isShown);
        fields[place].label.setVisible(isShown);
    }

    InstrumentView& view;
    int instrument = -1; ///< whose keys and objects are listed
    std::array<Field, count> fields;
};

} // namespace idiophone
