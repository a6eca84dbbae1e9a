#include "Analysis/RecordingFit.h"

#include "Analysis/BandPoles.h"
#include "Analysis/FreeDecay.h"
#include "Analysis/PoleRefinement.h"
#include "Analysis/PulseSpectrum.h"
#include "Object/NumberText.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <random>

namespace idiophone {
namespace {

constexpr double narrowestBandHz = 200;
// Where the band's filter first fits into the decay, the decay has fallen by 14 dB.
constexpr double fastestDecayPerWidth = 0.35;
constexpr double deepestPulse = 0.1;
// Rms relative to a recording's peak; any real room is noisier. Without noise, rounding errors
// would look like modes.
constexpr double ditherLevel = 3e-5; // −90 dB

struct Decays {
    std::vector<DecayRecording> recordings; ///< peak 1
    std::vector<double> peaks;
    std::vector<double> contactSeconds;
    std::vector<std::string> remarks;
};

Result<Decays> decaysOf(std::span<const StrikeRecording> recordings,
                        const RecordingFitSettings& settings) {
    Decays result;
    std::mt19937 random;
    const auto dither = [&] { // uniform, and the same on every machine
        constexpr double uniformRms = 0.28867513459481287;
        return ditherLevel / uniformRms * (std::ldexp(static_cast<double>(random()), -32) - 0.5);
    };
    for (const auto& recording : recordings) {
        const auto decay =
            findFreeDecay(recording.samples, recording.sampleRateHz, settings.contactSeconds);
        if (!decay)
            return failure(recording.name + ": " + decay.error().message);
        if (decay->clipped)
            result.remarks.push_back(recording.name +
                                     " is clipped, which adds partials that it has not.");
        if (decay->others)
            result.remarks.push_back(
                recording.name + " holds several strikes; the strongest at " +
                numberText(static_cast<double>(decay->onset) / recording.sampleRateHz, 3) +
                " s was taken.");
        const auto longest =
            static_cast<std::size_t>(settings.longestSeconds * recording.sampleRateHz);
        const auto samples =
            recording.samples.subspan(decay->begin, std::min(decay->end - decay->begin, longest));
        double peak = 0;
        for (const float sample : samples)
            peak = std::max(peak, std::abs(static_cast<double>(sample)));
        if (!(peak > 0))
            return failure(recording.name + ": nothing rings after its strongest strike");
        auto& kept = result.recordings.emplace_back();
        kept.sampleRateHz = recording.sampleRateHz;
        for (const float sample : samples)
            kept.samples.push_back(static_cast<double>(sample) / peak + dither());
        result.peaks.push_back(peak);
        result.contactSeconds.push_back(static_cast<double>(decay->begin - decay->onset) /
                                        recording.sampleRateHz);
    }
    return result;
}

void search(PoleRefinement& refinement, double highestHz) {
    using enum PoleRefinement::Background;
    const auto settle = [&] {
        refinement.refine(2, linear);
        if (refinement.dropDoubtful())
            refinement.refine(1, linear);
    };
    for (double width = narrowestBandHz; width < highestHz / 2; width *= 2) {
        const auto residuals = refinement.residuals();
        const BandPoles bands(residuals, width);
        std::vector<DecayPole> poles;
        for (double low = 0; low < highestHz; low += width)
            std::ranges::copy(bands.polesAbout(low + width / 2, fastestDecayPerWidth * width),
                              std::back_inserter(poles));
        refinement.add(poles);
        settle();
    }
    refinement.add(polesOfStart(refinement.residuals()));
    settle();
    refinement.refine(3, none);
    refinement.dropDoubtful();
    refinement.refine(2, none);
}

double energy(const MeasuredMode& mode) {
    double sum = 0;
    for (const double amplitude : mode.amplitudes)
        sum += amplitude * amplitude;
    return sum / mode.decayPerSecond;
}

double decibels(double energyRatio) {
    return 10 * std::log10(std::max(energyRatio, 1e-30));
}

double energyOf(const DecayRecording& recording) {
    double sum = 0;
    for (const double sample : recording.samples)
        sum += sample * sample;
    return sum;
}

} // namespace

Result<RecordingFit> fitRecordings(std::span<const StrikeRecording> recordings,
                                   const RecordingFitSettings& settings) {
    if (recordings.empty())
        return failure("There is no recording to fit.");
    auto decays = decaysOf(recordings, settings);
    if (!decays)
        return tl::unexpected(decays.error());
    double highestHz = std::numeric_limits<double>::infinity();
    for (const auto& recording : recordings)
        highestHz = std::min(highestHz, 0.49 * recording.sampleRateHz);

    PoleRefinement refinement(decays->recordings);
    search(refinement, highestHz);

    const auto found = refinement.modes();
    RecordingFit fit{.modes = {},
                     .modesFound = found.size(),
                     .remarks = std::move(decays->remarks),
                     .noiseDecibels = {}};
    for (const auto& [pole, amplitudes] : found) {
        auto& mode =
            fit.modes.emplace_back(MeasuredMode{pole.frequencyHz, pole.decayPerSecond, {}});
        for (std::size_t r = 0; r < amplitudes.size(); ++r) {
            // Extrapolate back to the equivalent impulse. That is the middle of the contact, or
            // near its onset if the length is unknown, because the estimate is likely too long.
            const double back = decays->contactSeconds[r] - settings.contactSeconds / 2;
            double gain = decays->peaks[r] * std::exp(pole.decayPerSecond * back);
            if (settings.contactSeconds > 0)
                gain /= std::max(pulseSpectrum(pole.frequencyHz * settings.contactSeconds),
                                 deepestPulse);
            mode.amplitudes.push_back(std::abs(amplitudes[r]) * gain);
        }
    }
    if (fit.modes.empty())
        return failure(recordings.front().name + ": nothing in it rings like a struck object");
    std::ranges::sort(fit.modes, std::greater{}, energy);
    fit.modes.resize(std::min(fit.modes.size(), settings.modeCount));
    std::ranges::sort(fit.modes, {}, &MeasuredMode::frequencyHz);
    const auto residuals = refinement.residuals();
    for (std::size_t r = 0; r < residuals.size(); ++r)
        fit.noiseDecibels.push_back(
            decibels(energyOf(residuals[r]) / energyOf(decays->recordings[r])));
    return fit;
}

} // namespace idiophone
