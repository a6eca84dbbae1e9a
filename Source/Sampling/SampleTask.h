// Plans all strikes of an export: of an instrument's keys, or of places of one of its objects.
#pragma once

#include "Sampling/SampleExport.h"
#include "Sampling/SamplePlan.h"

#include <array>
#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace idiophone {

/// A sample of a place on an object.
struct PlannedPlace {
    SurfaceStrike strike;
    std::array<double, 3> placeMetres{}; ///< in the object's coordinates
    std::string name;                    ///< of its file without the ending, such as "p03-v076"
};

/// Either `keys` or `places` is empty, and the other one not.
struct SampleTask {
    SampledInstrument sampled;
    std::string ending; ///< of the files: ".wav" or ".flac"
    std::vector<PlannedSample> keys = {};
    std::vector<PlannedPlace> places = {}; ///< by place, then velocity

    /// Returns the strikes in the order of `keys` or `places`, with their files.
    std::vector<SampleJob> jobsIn(const std::filesystem::path& folder) const;
};

/// Returns the keys from the lowest to the highest that play an object, at its size or resized.
std::vector<int> playedKeys(const Instrument& instrument, int lowest, int highest);

/// Returns the keys that have objects of their own.
std::vector<int> ownKeys(const Instrument& instrument);

/// Returns whether strikes of different turns sound different, so that they make round robins.
bool strikesVary(const ParameterValues& values);

/// `keys` are in rising order and not empty.
SampleTask taskOfKeys(SampledInstrument sampled,
                      std::span<const int> keys,
                      const SampleChoices& choices,
                      const std::string& ending);

/// Strikes so many places of a slot's object with each velocity (`layerVelocities`). The error is
/// the end of a sentence that begins with the object: it has fewer places.
Result<SampleTask> taskOfPlaces(SampledInstrument sampled,
                                std::size_t slot,
                                std::size_t places,
                                int velocities,
                                const std::string& ending);

} // namespace idiophone
