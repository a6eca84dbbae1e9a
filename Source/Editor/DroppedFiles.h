// Says what dropping files on the window does: which of them it opens, or why it opens none.
#pragma once

#include "Editor/ModeText.h"
#include "Editor/ProcessorView.h"
#include "Editor/Utf8.h"

#include <juce_core/juce_core.h>
#include <optional>
#include <string>

namespace idiophone {

/// One mesh, recording, modal object or preset, or a scale with its keyboard mapping. The first
/// readable file decides.
class DroppedFiles {
public:
    enum class Kind { unreadable, object, preset, tuning };

    /// `paths` is not empty. `midiNote` is the key under the mouse, if there is one; an object then
    /// plays on that key only. Reads no file.
    DroppedFiles(const juce::StringArray& paths,
                 const ProcessorView& processor,
                 std::optional<int> midiNote = {})
        : all(paths), view(processor), key(midiNote) {
        for (const auto& path : paths) {
            const auto each = kindOf(path);
            if (opened.isEmpty() ? each != Kind::unreadable
                                 : each == Kind::tuning && common == Kind::tuning) {
                common = each;
                opened.add(path);
            }
        }
    }

    Kind kind() const { return common; }
    /// For the time before the drop: "Drop to play teapot.obj".
    juce::String offer() const {
        if (common == Kind::unreadable)
            return unreadable();
        juce::StringArray names;
        for (const auto& path : opened)
            names.add(common == Kind::preset ? juce::File(path).getFileNameWithoutExtension()
                                             : juce::File(path).getFileName());
        const int others = all.size() - opened.size();
        return (common == Kind::tuning   ? "Drop to tune the keys to "
                : common == Kind::preset ? "Drop to load the preset "
                                         : "Drop to play ") +
               names.joinIntoString(" and ") +
               (common == Kind::object && key ? " on " + noteName(*key) : juce::String()) +
               (others == 0   ? juce::String()
                : others == 1 ? ", without the other file"
                              : ", without the other " + juce::String(others) + " files");
    }
    /// For the status line after the drop of files that cannot be opened.
    std::string refusal() const {
        const auto patterns = fromUtf8(view.workshop.openPatterns() + ";" +
                                       view.tuning.tuningPatterns() + ";*" + presetEnding);
        return (juce::File(all[0]).getFileName().quoted() + " is not opened here: it is none of " +
                patterns.removeCharacters("*").replace(";", ", ") + ".")
            .toStdString();
    }

    /// Opens the files. The status shows errors.
    void open() const {
        switch (common) {
        case Kind::unreadable:
            return view.status.reportError(refusal());
        case Kind::preset:
            if (const auto done = view.presets.openPresetFile(pathOf(opened[0])); !done)
                view.status.reportError(done.error().message);
            return;
        case Kind::tuning: // a scale and its mapping arrive together
            for (const auto& file : opened)
                view.tuning.openTuning(pathOf(file));
            return;
        case Kind::object:
            return key ? view.workshop.openFileOnKey(pathOf(opened[0]), *key)
                       : view.workshop.openFile(pathOf(opened[0]));
        }
    }

private:
    static constexpr const char* presetEnding = ".json";

    Kind kindOf(const juce::String& path) const {
        if (view.tuning.isTuningFile(pathOf(path)))
            return Kind::tuning;
        if (view.workshop.canOpen(pathOf(path)))
            return Kind::object;
        return juce::File(path).hasFileExtension(presetEnding) ? Kind::preset : Kind::unreadable;
    }
    juce::String unreadable() const {
        if (juce::File(all[0]).isDirectory())
            return "Idiophone opens files, not folders";
        juce::StringArray endings;
        for (const auto& path : all)
            endings.addIfNotAlreadyThere(juce::File(path).getFileExtension(), true);
        if (endings.size() > 1)
            return "Idiophone can read none of these " + juce::String(all.size()) + " files";
        return "Idiophone cannot read " +
               (endings[0].isEmpty() ? juce::File(all[0]).getFileName() : endings[0]) +
               (all.size() > 1 ? " files" : "");
    }

    juce::StringArray all, opened;
    const ProcessorView& view;
    std::optional<int> key;
    Kind common = Kind::unreadable;
};

} // namespace idiophone
