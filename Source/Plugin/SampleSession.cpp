#include "Plugin/SampleSession.h"

#include "Editor/Utf8.h"
#include "Instrument/OwnSlots.h"
#include "Object/FileBytes.h"
#include "Object/FileName.h"
#include "Sampling/SampleFolder.h"

#include <utility>

namespace idiophone {
namespace {

/// A name for the folder of the samples in `parent`, or `parent` itself if it has samples.
std::filesystem::path folderIn(const std::filesystem::path& parent, const SampleOrder& order) {
    if (holdsSamples(parent))
        return parent;
    const auto& preset = order.sampled.preset.name;
    auto name = fileNameFrom(preset.empty() ? "Idiophone" : preset);
    if (order.settings.source == SampleSettings::Source::places)
        name += " places " + std::to_string(order.settings.object + 1);
    return parent / pathOf(fromUtf8(name).trim());
}

} // namespace

void SampleSession::estimateSamples(const SampleSettings& settings) {
    if (worker.status().isExporting())
        return;
    auto subject = subjectOf(settings);
    if (subject == last || keepsResult(subject))
        return;
    worker.start(orderOf(subject));
    last = std::move(subject);
}

/// The result of an export stays until other settings are chosen or another sound is loaded.
bool SampleSession::keepsResult(const Subject& subject) const {
    using enum SampleStatus::Stage;
    const auto stage = worker.status().stage;
    return (stage == done || stage == stopped || stage == failed) && last &&
           subject.settings == last->settings && subject.loadNumber == last->loadNumber;
}

void SampleSession::exportSamples(const SampleSettings& settings,
                                  const std::filesystem::path& parent) {
    auto subject = subjectOf(settings);
    auto order = orderOf(subject);
    order.folder = folderIn(parent, order);
    if (fileOf(order.folder).createDirectory().failed())
        return session.reportError("The samples are not exported: there can be no folder " +
                                   nameOf(order.folder) + ".");
    failureShown = false;
    worker.start(std::move(order));
    last = std::move(subject);
}

void SampleSession::stopExport() {
    if (worker.status().isExporting())
        worker.stop();
}

void SampleSession::poll() {
    if (failureShown)
        return;
    const auto status = worker.status();
    if (status.isExporting())
        return;
    failureShown = true;
    if (status.stage == SampleStatus::Stage::failed)
        session.reportError(status.sentence);
}

SampleSession::Subject SampleSession::subjectOf(const SampleSettings& settings) const {
    const auto held = session.lock();
    return {.settings = settings,
            .loadNumber = session.number(),
            .values = shared.parameters.values(),
            .muted = session.playing().preset.mutedModes,
            .tuning = tuning.files()};
}

SampleOrder SampleSession::orderOf(const Subject& subject) const {
    const auto sound = session.loadedSound();
    SampleOrder order{
        .sampled = {.instrument = sound.instrument,
                    .preset = sound.preset,
                    .values = subject.values,
                    .sampleRateHz = static_cast<double>(subject.settings.sampleRateHz)},
        .settings = subject.settings};
    order.sampled.values.set(ParameterId::bypass, 0);
    if (subject.tuning.isGiven())
        order.sampled.tuning = keyTuning(subject.tuning).value_or(KeyTuning());
    if (sound.instrument == nullptr)
        return order;
    const auto slots = ownSlots(*sound.instrument);
    order.slot = subject.settings.object < slots.size() ? slots[subject.settings.object]
                                                        : sound.instrument->slots().size();
    return order;
}

} // namespace idiophone
