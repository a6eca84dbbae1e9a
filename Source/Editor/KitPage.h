// The page of a kit: its parts in a list, the fields of the selected one, and buttons to add and
// remove parts. For another sound it says how to make a kit.
#pragma once

#include "Editor/DeckPage.h"
#include "Editor/FileButton.h"
#include "Editor/KitFields.h"
#include "Editor/KitList.h"
#include "Editor/ProcessorView.h"
#include "Editor/ReportText.h"
#include "Editor/WorkProgress.h"

#include <algorithm>
#include <bitset>
#include <functional>
#include <optional>
#include <vector>

namespace idiophone {

class KitPage final : public DeckPage {
public:
    explicit KitPage(ProcessorView& processor)
        : DeckPage("Kit"), view(processor),
          add({},
              "Add an object to the kit",
              "Open a mesh, a recording or a modal object for this key. Dropping it on the key "
              "does "
              "the same. Click a key of the keyboard to choose another one.",
              fromUtf8(processor.workshop.openPatterns()),
              [this](const std::filesystem::path& file) { addObject(file); }) {
        addButton(remove, "Remove the part", "Take the selected part out of the kit",
                  [this] { removeSelected(); });
        addButton(make, "Make a kit of this sound",
                  "The sound becomes a kit of one part, which sounds as before",
                  [this] { view.kit.makeKit(); });
        list.onSelect = [this] { showPart(); };
        list.onRemove = [this] { removeSelected(); };
        fields.onChange = [this](const KitView::Part& wanted) {
            view.kit.changePart(selected(), wanted);
            refresh();
        };
        showParts(*this, list, fields, add, remove, hint);
        addChildComponent(bar);
        showKit();
    }

    /// Called with the keys of the selected part when they change; with nothing while the page is
    /// hidden or the sound is no kit.
    std::function<void(std::optional<InstrumentView::KeyRange>)> onKeysShown;

    /// Selects the part that plays a key, and lets the next object go on this key.
    void chooseKey(int midiNote) {
        chosenKey = midiNote;
        const auto found = std::ranges::find_if(parts, [midiNote](const KitView::Part& part) {
            return part.lowestNote <= midiNote && midiNote <= part.highestNote;
        });
        if (found != parts.end() && !plays(selected(), midiNote))
            list.selectRow(static_cast<int>(std::distance(parts.begin(), found)));
        showKeys();
    }
    /// The key that the next object goes on: the chosen one, or the lowest free one.
    int keyToAdd() const {
        if (chosenKey)
            return *chosenKey;
        auto taken = pendingKeys;
        for (const auto& part : parts)
            for (int note = part.lowestNote; note <= part.highestNote; ++note)
                taken.set(static_cast<std::size_t>(note));
        const int lowest =
            parts.empty() ? 0 : std::ranges::min(parts, {}, &KitView::Part::lowestNote).lowestNote;
        for (int step = 0; step < noteCount; ++step) // upwards from the lowest, then from 0
            if (const int note = (lowest + step) % noteCount;
                !taken.test(static_cast<std::size_t>(note)))
                return note;
        return lowest;
    }
    /// Puts the object of a file on that key.
    void addObject(const std::filesystem::path& file) {
        const int key = keyToAdd();
        view.workshop.openFileOnKey(file, key);
        pendingKeys.set(static_cast<std::size_t>(key));
        chosenKey.reset();
        refresh();
    }

    void refresh() override {
        const auto job = view.workshop.importStatus();
        bar.setVisible(job.isWorking());
        bar.show(job.progress);
        if (!job.isWorking())
            pendingKeys.reset();
        if (view.instrument.instrumentNumber() != shownInstrument)
            showKit();
        else
            showKeys();
    }
    void resized() override {
        constexpr int line = 26, gap = 6, hintHeight = 42;
        auto area = getLocalBounds().reduced(padding);
        hint.setBounds(area.withHeight(hintHeight));
        make.setBounds(area.withTrimmedTop(hintHeight + gap).withSize(190, line));
        auto buttons = area.removeFromBottom(line);
        remove.setBounds(buttons.removeFromRight(80));
        add.setBounds(buttons.removeFromLeft(170));
        bar.setBounds(area.removeFromBottom(gap).withHeight(WorkBar::height));
        fields.setBounds(area.removeFromBottom(KitFields::height));
        area.removeFromBottom(gap);
        list.setBounds(area);
    }
    void visibilityChanged() override { showKeys(); }
    void lookAndFeelChanged() override { showHint(); }

private:
    static constexpr int noteCount = 128;

    std::size_t selected() const {
        return static_cast<std::size_t>(std::max(list.getSelectedRow(), 0));
    }
    bool plays(std::size_t part, int note) const {
        return part < parts.size() && parts[part].lowestNote <= note &&
               note <= parts[part].highestNote;
    }
    void removeSelected() {
        view.kit.removePart(selected());
        refresh();
    }

    /// Selects a part that was added. Another sound has no chosen key.
    void showKit() {
        shownInstrument = view.instrument.instrumentNumber();
        auto now = view.kit.kitParts();
        const auto before = std::max<std::size_t>(parts.size(), 1);
        const auto row = now.size() == before + 1 ? before : selected();
        if (now.empty() || now.size() > before + 1 || now.size() + 1 < before)
            chosenKey.reset();
        parts = std::move(now);
        list.show(parts, static_cast<int>(row));
        const bool isKit = !parts.empty();
        for (auto* part : std::initializer_list<juce::Component*>{&list, &fields, &add, &remove})
            part->setVisible(isKit);
        remove.setEnabled(parts.size() > 1);
        hint.setVisible(!isKit);
        make.setVisible(!isKit);
        showHint();
        showPart();
    }
    void showHint() {
        const auto possible = view.kit.canBeKit();
        make.setEnabled(possible.has_value());
        hint.show(possible
                      ? juce::String("To make this sound a kit of several objects, drop a mesh, "
                                     "a recording or a modal object on a key of the keyboard.")
                      : "This sound cannot be a kit: " + fromUtf8(possible.error().message) + ".",
                  LookColour::text);
    }
    void showPart() {
        if (selected() < parts.size())
            fields.show(parts[selected()]);
        showKeys();
    }
    void showKeys() {
        add.setButtonText("Add object on " + noteName(keyToAdd()) + "...");
        const auto keys = isVisible() && selected() < parts.size()
                              ? std::optional(keysOf(parts[selected()]))
                              : std::nullopt;
        if (keys == lastKeys)
            return;
        lastKeys = keys;
        juce::NullCheckedInvocation::invoke(onKeysShown, keys);
    }

    ProcessorView& view;
    int shownInstrument = -1;
    std::vector<KitView::Part> parts; ///< as shown
    std::optional<int> chosenKey;
    std::bitset<noteCount> pendingKeys; ///< of objects that are still being made
    std::optional<InstrumentView::KeyRange> lastKeys;
    KitList list;
    KitFields fields;
    FileButton add;
    juce::TextButton remove{"Remove"}, make{"Make a kit of this sound"};
    ReportText hint{"How to make a kit"};
    WorkBar bar; ///< of an object that is being made
};

} // namespace idiophone
