#include "Analysis/SurfaceFit.h"
#include "AudioFiles/AudioFileReader.h"
#include "Console/Command.h"
#include "Console/JsonText.h"
#include "Console/OptionChecks.h"
#include "Instrument/SurfaceFile.h"
#include "Object/FileBytes.h"
#include "Object/TextFile.h"

#include <iomanip>
#include <iostream>

namespace idiophone {
namespace {

struct SurfaceOptions {
    std::filesystem::path recording;
    std::filesystem::path output;
    double speedMetresPerSecond = 1;
    bool json = false;
};

/// Makes a surface. Its reference speed is that of the recording, so that the profile equals the
/// recorded one at this speed.
Surface surfaceOf(const SurfaceFit& fit, const SurfaceOptions& options) {
    const auto& named = options.output.empty() ? options.recording : options.output;
    return Surface{.name = nameOf(named.stem()),
                   .spectrumExponent = fit.spectrumExponent,
                   .resonFrequencyHz = fit.resonFrequencyHz,
                   .resonDampingPerSecond = fit.resonDampingPerSecond,
                   .referenceSpeedMetresPerSecond = options.speedMetresPerSecond,
                   .slowestSpeedMetresPerSecond = options.speedMetresPerSecond / 10};
}

void report(const Surface& surface, const SurfaceFit& fit, const SurfaceOptions& options) {
    if (options.json) {
        auto result = nlohmann::ordered_json::parse(encodeSurface(surface));
        result["fractal_dimension"] = surface.fractalDimension();
        result["fitted_up_to_hz"] = fit.highestFrequencyHz;
        std::cout << jsonText(result);
        return;
    }
    std::cout << std::fixed << std::setprecision(2) << nameOf(options.recording)
              << ": spectrum exponent " << surface.spectrumExponent << " (fractal dimension "
              << surface.fractalDimension() << "), reson " << std::setprecision(1)
              << surface.resonFrequencyHz << " Hz, damping " << surface.resonDampingPerSecond
              << " 1/s, fitted up to " << std::setprecision(0) << fit.highestFrequencyHz << " Hz\n"
              << std::flush;
}

Result<void> fitRecording(const SurfaceOptions& options) {
    const auto recording = readRecording(options.recording);
    if (!recording)
        return tl::unexpected(recording.error());
    const auto refuse = [&](const Error& error) {
        return failure(nameOf(options.recording) + ": " + error.message);
    };
    const auto fit = fitSurface(recording->samples, recording->sampleRateHz);
    if (!fit)
        return refuse(fit.error());
    const auto fitted = surfaceOf(*fit, options);
    const auto surface = validated(heldToRanges(fitted));
    if (!surface)
        return refuse(surface.error());
    if (*surface != fitted)
        std::cerr << "warning: " << nameOf(options.recording)
                  << ": it is no scrape with a clear resonance, so figures out of range were "
                     "limited\n";
    if (!options.output.empty())
        if (auto written = writeTextFile(options.output, encodeSurface(*surface)); !written)
            return written;
    report(*surface, *fit, options);
    return {};
}

} // namespace

void addSurface(CLI::App& program, Action& chosen) {
    const auto [command, options] = addCommand<SurfaceOptions>(
        program, chosen, "surface", "Fits a surface to the recording of a steady scrape",
        fitRecording);
    command
        ->add_option("RECORDING", options->recording,
                     "A WAV, FLAC or AIFF file of at least a quarter of a second")
        ->required();
    command->add_option("-o,--output", options->output, "The surface file (.json) to write")
        ->type_name(writtenFile);
    command
        ->add_option("--speed", options->speedMetresPerSecond,
                     "Speed of the recorded contact, in m/s")
        ->check(numberBetween(0.001, 100))
        ->capture_default_str();
    command->add_flag("--json", options->json, "Writes the report as JSON");
}

} // namespace idiophone
