#include "Analysis/RecordingRest.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace idiophone {
namespace {

constexpr double contactSeconds = 0.02;
constexpr double smallestShare = 0.0005;
constexpr std::size_t mostFrequencies = 6;

double energyOf(std::span<const double> samples) {
    double sum = 0;
    for (const double sample : samples)
        sum += sample * sample;
    return sum;
}

} // namespace

RecordingRest restOf(const DecayRecording& recording,
                     std::span<const double> rest,
                     std::span<const DampedSinusoid> steadyTones,
                     std::size_t index,
                     double noiseEnergy) {
    const auto count = static_cast<double>(recording.samples.size());
    const double total = std::max(energyOf(recording.samples), 1e-300);
    RecordingRest shares;
    for (const auto& [pole, amplitudes] : steadyTones) {
        shares.steadyTones += std::norm(amplitudes[index]) / 2 * count / total;
        shares.steadyHz.push_back(pole.frequencyHz);
    }
    shares.steadyTones = std::min(shares.steadyTones, 1.0);
    const double left = std::min(energyOf(rest) / total, 1.0);
    const auto early =
        std::min(rest.size(), static_cast<std::size_t>(contactSeconds * recording.sampleRateHz));
    const double noise = noiseEnergy * count / total;
    const double noiseEarly = noise * static_cast<double>(early) / count;
    shares.contact = std::max(energyOf(rest.first(early)) / total - noiseEarly, 0.0);
    shares.noise = std::min(noise, left - shares.contact);
    shares.others = left - shares.noise - shares.contact;
    shares.modes = std::max(0.0, 1 - left - shares.steadyTones);
    return shares;
}

std::string RecordingRest::sentence() const {
    std::ostringstream text;
    text << std::fixed << std::setprecision(1) << "The modes hold " << 100 * modes
         << " % of the sound.";
    std::ostringstream parts;
    parts << std::fixed << std::setprecision(1);
    const auto add = [&](double share, const std::string& name) {
        if (share >= smallestShare)
            parts << (parts.str().empty() ? "" : ", ") << 100 * share << " % " << name;
    };
    std::ostringstream tones;
    for (std::size_t i = 0; i < std::min(steadyHz.size(), mostFrequencies); ++i)
        tones << (i == 0 ? "" : ", ") << std::lround(steadyHz[i]);
    add(contact, "noise of the contact");
    add(steadyTones, "hum and other steady tones (" + tones.str() + " Hz)");
    add(noise, "steady noise and rumble");
    add(others, "the room and modes too faint to keep");
    if (!parts.str().empty())
        text << " The rest: " << parts.str() << '.';
    return text.str();
}

} // namespace idiophone
