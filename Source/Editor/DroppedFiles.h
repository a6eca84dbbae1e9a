// Says what dropping files on the window does: which of them it opens, or why it opens none.
#pragma once

#include "Editor/ProcessorView.h"
#include "Editor/Utf8.h"

#include <juce_core/juce_core.h>
#include <string>

namespace idiophone {

/// One mesh or modal object, or a scale with its keyboard mapping. The first readable file decides.
class DroppedFiles {
public:
    /// `paths` is not empty. Reads no file.
    DroppedFiles(const juce::StringArray& paths, const ProcessorView& processor)
        : all(paths), view(processor) {
        for (const auto& path : paths) {
            const bool isTuning = view.tuning.isTuningFile(pathOf(path));
            if (opened.isEmpty() ? isTuning || view.workshop.canOpen(pathOf(path))
                                 : tunes && isTuning) {
                tunes = isTuning;
                opened.add(path);
            }
        }
    }

    bool isReadable() const { return !opened.isEmpty(); }
    /// Whether the opened files are scales and keyboard mappings.
    bool isTuning() const { return tunes; }
    /// The files that a drop opens: one object, or all that tune the keys.
    const juce::StringArray& toOpen() const { return opened; }

    /// For the time before the drop: "Drop to play teapot.obj".
    juce::String offer() const {
        if (!isReadable())
            return unreadable();
        juce::StringArray names;
        for (const auto& path : opened)
            names.add(juce::File(path).getFileName());
        const int others = all.size() - opened.size();
        return (tunes ? "Drop to tune the keys to " : "Drop to play ") +
               names.joinIntoString(" and ") +
               (others == 0   ? juce::String()
                : others == 1 ? ", without the other file"
                              : ", without the other " + juce::String(others) + " files");
    }
    /// For the status line after the drop of files that cannot be opened.
    std::string refusal() const {
        const juce::File file(all[0]);
        juce::String reason = "presets belong in the folder that the preset browser shows, "
                              "materials in Materials beside it, and a preset names the scene that "
                              "it plays.";
        if (!isPresetLike(all[0])) {
            const auto patterns =
                fromUtf8(view.workshop.openPatterns() + ";" + view.tuning.tuningPatterns());
            reason = "it is none of " + patterns.removeCharacters("*").replace(";", ", ") + ".";
        }
        return (file.getFileName().quoted() + " is not opened here: " + reason).toStdString();
    }

private:
    static bool isPresetLike(const juce::String& path) {
        return juce::File(path).hasFileExtension("json");
    }

    juce::String unreadable() const {
        if (isPresetLike(all[0]))
            return "Copy presets into the folder that the preset browser shows";
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
    bool tunes = false;
};

} // namespace idiophone
