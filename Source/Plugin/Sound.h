// Holds a whole sound that can be kept and played again. Cheap to copy, because objects are shared.
#pragma once

#include "Editor/PresetShelf.h"
#include "Instrument/Instrument.h"
#include "Instrument/Preset.h"
#include "Plugin/ObjectEmbedding.h"

#include <cstdint>
#include <memory>
#include <string>

namespace idiophone {

struct Sound {
    Preset preset; ///< as loaded; its values are the reference of "match loudness"
    std::shared_ptr<const Instrument> instrument = {};
    ParameterValues parameters;                         ///< current values
    std::shared_ptr<const MissingObjects> missing = {}; ///< replaced by a stand-in, or null
    std::string presetId = {}; ///< of the preset on the shelf (PresetShelf.h), or empty
    /// Hash of that preset's file when the sound was read from it or written to it. 0 for a factory
    /// preset and without a preset.
    std::uint64_t presetContent = 0;
    ParameterValues stored; ///< values of that preset, to detect changes

    bool operator==(const Sound&) const = default;
};

/// Returns a preset's details with an empty folder.
inline PresetDetails detailsOf(const Preset& preset) {
    return {.name = preset.name,
            .folder = {},
            .author = preset.author,
            .description = preset.description,
            .tags = preset.tags};
}

/// Holds the current sound and plays others; SoundSession implements it. For the message thread.
class SoundHolder {
public:
    virtual ~SoundHolder() = default;

    /// Returns the current sound; its instrument is null if none could be loaded.
    virtual Sound loadedSound() const = 0;
    /// Returns the preset of the current sound, with an empty folder, without copying the sound.
    virtual PlayingPreset playingPreset() const = 0;
    /// Plays the sound at once and keeps the present setup. If the instrument or its preset
    /// differs, the old sound fades out. If only parameters change, it rings on, unless the level
    /// changes by more than 12 dB and there is no stage. Returns false for a sound without an
    /// instrument, and, with a report, if memory does not suffice.
    virtual bool playSound(const Sound& sound) = 0;
    /// If the current sound has the instrument of `wanted`, gives it that preset's name, author,
    /// description, tags, id, file hash and stored values. Keeps everything else.
    virtual void relabel(const Sound& wanted) = 0;
    /// Shows a sentence in the status line.
    virtual void reportError(const std::string& sentence) = 0;
    /// Sets the parameters that differ between `wanted` and the sound `of`, all at once, if that
    /// sound still plays. Leaves the others where automation has moved them. The old sound fades
    /// out or rings on as in `playSound`.
    virtual void changeParameters(const Sound& of, const ParameterValues& wanted) = 0;
};

} // namespace idiophone
