#include "Plugin/TuningSession.h"

#include "Object/TextFile.h"

#include <utility>

namespace idiophone {

void TuningSession::openTuning(const std::filesystem::path& file) {
    ScalaTuning before, wanted;
    const auto tuned = readTextFile(file, ScalaTuning::largestFileBytes)
                           .and_then([&](const std::string& text) -> Result<void> {
                               const auto held = session.lock();
                               before = wanted = scala;
                               (matches(file, scaleFiles) ? wanted.scale : wanted.mapping) =
                                   ScalaFile{.name = fileNameOf(file), .text = text};
                               return keyTuning(wanted).transform(
                                   [&](const KeyTuning& keys) { tuneTo(wanted, keys); });
                           });
    if (!tuned)
        return session.reportError(tuned.error().message);
    record(fileNameOf(file), before, wanted);
}

void TuningSession::forgetTuning() {
    ScalaTuning before;
    {
        const auto held = session.lock();
        if (!scala.isGiven())
            return shared.messages.tuner.forgetMessages();
        before = scala;
        tuneTo({}, {});
    }
    record("Forget tuning", before, {});
}

/// Records the change as an undo step and reports it to the host.
void TuningSession::record(const std::string& step,
                           const ScalaTuning& before,
                           const ScalaTuning& after) {
    const auto tune = [this](const ScalaTuning& wanted) {
        {
            const auto held = session.lock();
            if (const auto keys = keyTuning(wanted)) // a recorded tuning was valid
                tuneTo(wanted, *keys);
        }
        shared.reporter.reportState();
    };
    if (before != after)
        history.recordDone(
            step, [tune, before] { tune(before); }, [tune, after] { tune(after); });
    shared.reporter.reportState();
}

void TuningSession::tuneTo(ScalaTuning files, const KeyTuning& keys) noexcept {
    scala = std::move(files);
    shared.tail.setTuning(keys);
    shared.messages.tuner.setOwn(scala.isGiven() ? std::optional(keys) : std::nullopt);
}

TuningStatus TuningSession::tuningStatus() const {
    using Source = TuningStatus::Source;
    {
        const auto held = session.lock();
        if (scala.isGiven())
            return {.source = Source::files,
                    .scale = scaleTitle(scala),
                    .mappingFile = scala.mapping.name};
    }
    if (shared.messages.tuner.hasMaster())
        return {.source = Source::session,
                .scale = shared.messages.tuner.masterScaleName(),
                .mappingFile = {}};
    if (shared.messages.tuner.isTunedByMessages())
        return {.source = Source::messages, .scale = "Tuned by MIDI", .mappingFile = {}};
    return {.source = Source::equal, .scale = scaleTitle({}), .mappingFile = {}};
}

} // namespace idiophone
