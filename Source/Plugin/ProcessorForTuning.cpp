// How the keys are tuned: Scala files of this instance's own, kept in its state.
#include "Object/TextFile.h"
#include "Plugin/FileKinds.h"
#include "Plugin/Processor.h"

namespace idiophone {

bool Processor::isTuningFile(const std::filesystem::path& file) const {
    return isScale(file) || isKeyboardMapping(file);
}

std::string Processor::tuningPatterns() const {
    return tuningFilePatterns();
}

void Processor::openTuning(const std::filesystem::path& file) {
    const auto tuned = readTextFile(file, ScalaTuning::largestFileBytes)
                           .and_then([&](const std::string& text) -> Result<void> {
                               const std::scoped_lock lock(soundMutex);
                               auto wanted = scala;
                               (isScale(file) ? wanted.scale : wanted.mapping) = {
                                   .name = fileNameOf(file), .text = text};
                               return keyTuning(wanted).transform(
                                   [&](const KeyTuning& keys) { tuneTo(wanted, keys); });
                           });
    if (!tuned)
        return reportError(tuned.error().message);
    updateHostDisplay(ChangeDetails().withNonParameterStateChanged(true));
}

void Processor::forgetTuning() {
    {
        const std::scoped_lock lock(soundMutex);
        tuneTo({}, {});
    }
    updateHostDisplay(ChangeDetails().withNonParameterStateChanged(true));
}

/// Under soundMutex.
void Processor::tuneTo(const ScalaTuning& wanted, const KeyTuning& keys) {
    giveUpRefused();
    scala = wanted;
    tuner.setOwn(wanted.isGiven() ? std::optional(keys) : std::nullopt);
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
