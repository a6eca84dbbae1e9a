// Tunes the keys by Scala files, which this instance keeps in its state.
#include "Object/TextFile.h"
#include "Plugin/FileKinds.h"
#include "Plugin/Processor.h"

#include <utility>

namespace idiophone {

bool Processor::isTuningFile(const std::filesystem::path& file) const {
    return isScale(file) || isKeyboardMapping(file);
}

std::string Processor::tuningPatterns() const {
    return tuningFilePatterns();
}

void Processor::openTuning(const std::filesystem::path& file) {
    ScalaTuning before, wanted;
    const auto tuned = readTextFile(file, ScalaTuning::largestFileBytes)
                           .and_then([&](const std::string& text) -> Result<void> {
                               const std::scoped_lock lock(soundMutex);
                               before = wanted = scala;
                               (isScale(file) ? wanted.scale : wanted.mapping) = {
                                   .name = fileNameOf(file), .text = text};
                               return keyTuning(wanted).transform(
                                   [&](const KeyTuning& keys) { tuneTo(wanted, keys); });
                           });
    if (!tuned)
        return reportError(tuned.error().message);
    recordTuning(fileNameOf(file), before, wanted);
}

void Processor::forgetTuning() {
    ScalaTuning before;
    {
        const std::scoped_lock lock(soundMutex);
        if (!scala.isGiven())
            return tuner.forgetMessages();
        before = scala;
        tuneTo({}, {});
    }
    recordTuning("Forget tuning", before, {});
}

/// Records the change as an undo step and reports it to the host.
void Processor::recordTuning(const std::string& step,
                             const ScalaTuning& before,
                             const ScalaTuning& after) {
    const auto tellHost = [this] {
        updateHostDisplay(ChangeDetails().withNonParameterStateChanged(true));
    };
    const auto tune = [this, tellHost](const ScalaTuning& wanted) {
        {
            const std::scoped_lock lock(soundMutex);
            if (const auto keys = keyTuning(wanted)) // valid when it was recorded
                tuneTo(wanted, *keys);
        }
        tellHost();
    };
    if (before != after)
        history.recordDone(
            step, [tune, before] { tune(before); }, [tune, after] { tune(after); });
    tellHost();
}

/// Call under soundMutex. Moves the texts instead of copying, so that nothing fails within a
/// hand-over.
void Processor::tuneTo(ScalaTuning wanted, const KeyTuning& keys) {
    scala = std::move(wanted);
    ownKeys = keys;
    if (instrument != nullptr)
        semitonesBelowTuned = semitonesBelowEqual(*instrument, keys);
    tuner.setOwn(scala.isGiven() ? std::optional(keys) : std::nullopt);
}

TuningStatus Processor::tuningStatus() const {
    using enum TuningStatus::Source;
    {
        const std::scoped_lock lock(soundMutex);
        if (scala.isGiven())
            return {.source = files, .scale = scaleTitle(scala), .mappingFile = scala.mapping.name};
    }
    if (tuner.hasMaster())
        return {.source = session, .scale = tuner.masterScaleName(), .mappingFile = {}};
    if (tuner.isTunedByMessages())
        return {.source = messages, .scale = "Tuned by MIDI", .mappingFile = {}};
    return {.source = equal, .scale = scaleTitle({}), .mappingFile = {}};
}

} // namespace idiophone
