#include "Plugin/SoundMonitor.h"

#include <algorithm>

namespace idiophone {
namespace {

constexpr double picturesPerSecond = 30;
constexpr double secondsToMeasureOn = 1; // after the window last asked

} // namespace

void SoundMonitor::prepare(double sampleRateHz) {
    rateHz = sampleRateHz;
    watchedSamples = samplesSincePicture = 0;
    peaks = {};
    load.reset(sampleRateHz, 1); // every callback passes its own length
}

const MonitoredSound* SoundMonitor::take() {
    if (latest == nullptr) {
        latest = std::make_unique<LatestValue<MonitoredSound>>(MonitoredSound());
        wanted = true;
        return nullptr;
    }
    const auto* newest = latest->take();
    if (newest != nullptr)
        wanted = true;
    return newest;
}

SoundMonitor::Callback::Callback(SoundMonitor& watching,
                                 const PlayerCrossfade& played,
                                 int callbackSamples) noexcept
    : monitor(watching), sound(played), samples(callbackSamples) {
    if (monitor.wanted)
        monitor.watchedSamples = secondsToMeasureOn * monitor.rateHz;
    if (monitor.watchedSamples > 0 && samples > 0)
        timer.emplace(monitor.load, samples);
}

SoundMonitor::Callback::~Callback() {
    if (monitor.watchedSamples <= 0)
        return;
    timer.reset();
    monitor.watchedSamples -= samples;
    monitor.samplesSincePicture += samples;
    if (!monitor.wanted || monitor.samplesSincePicture < monitor.rateHz / picturesPerSecond ||
        sound.player() == nullptr)
        return;
    monitor.samplesSincePicture = 0;
    monitor.takePicture(*sound.player());
}

void SoundMonitor::addPeak(std::size_t channel, float peak) noexcept {
    if (watchedSamples > 0 && channel < peaks.size())
        peaks[channel] = std::max(peaks[channel], peak);
}

void SoundMonitor::takePicture(const Player& player) noexcept {
    const Synthesiser& synthesiser = player.synthesiser();
    MonitoredSound& seen = latest->next();
    seen.instrument = player.instrument().serialNumber();
    seen.sampleRateHz = synthesiser.sampleRateHz();
    seen.slot = slotToShow(player);
    synthesiser.report(seen.slot, seen.groups);
    const auto status = synthesiser.status();
    seen.slotCount = std::min(status.size(), seen.slots.size());
    std::copy_n(status.begin(), seen.slotCount, seen.slots.begin());
    const auto bodies = player.stage().bodyPoses();
    seen.bodyCount = std::min(bodies.size(), seen.bodies.size());
    std::copy_n(bodies.begin(), seen.bodyCount, seen.bodies.begin());
    seen.velocity = player.velocityStruckLast();
    seen.qualitySlope = synthesiser.settings().qualitySlope;
    seen.modeBudget = synthesiser.settings().modeBudget;
    seen.load = static_cast<float>(load.getLoadAsProportion());
    seen.peaks = std::exchange(peaks, {});
    // Clear the request before publishing: the reader sets it to ask for the next picture.
    wanted = false;
    latest->publish();
}

std::size_t SoundMonitor::slotToShow(const Player& player) const noexcept {
    const auto slots = player.instrument().slots();
    const auto last = player.slotPlayedLast();
    const int watched = watchedSlot;
    if (watched < 0 || static_cast<std::size_t>(watched) >= slots.size())
        return last.value_or(0);
    const auto asked = static_cast<std::size_t>(watched);
    return last && slots[*last].object == slots[asked].object ? *last : asked;
}

} // namespace idiophone
