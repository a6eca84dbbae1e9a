#include "Sampling/SampleTask.h"

#include "Object/FileBytes.h"
#include "Sampling/ObjectPlaces.h"
#include "World/ObjectSurface.h"

#include <cstdint>
#include <cstdio>

namespace idiophone {

std::vector<SampleJob> SampleTask::jobsIn(const std::filesystem::path& folder) const {
    std::vector<SampleJob> jobs;
    for (const auto& sample : keys)
        jobs.push_back({.strike = {.by = SampledStrike::KeyStrike{.key = sample.key,
                                                                  .velocity = sample.velocity},
                                   .turn = static_cast<std::uint64_t>(sample.roundRobin - 1)},
                        .file = folder / pathNamed(sample.name + ending)});
    for (const auto& place : places)
        jobs.push_back(
            {.strike = {.by = place.strike}, .file = folder / pathNamed(place.name + ending)});
    return jobs;
}

std::vector<int> playedKeys(const Instrument& instrument, int lowest, int highest) {
    std::vector<int> keys;
    for (int key = lowest; key <= highest; ++key)
        if (instrument.key(key).slot >= 0)
            keys.push_back(key);
    return keys;
}

std::vector<int> ownKeys(const Instrument& instrument) {
    std::vector<int> keys;
    for (int key = 0; key < 128; ++key)
        if (instrument.hasOwn(key))
            keys.push_back(key);
    return keys;
}

bool strikesVary(const ParameterValues& values) {
    return values[ParameterId::strikeSpread] > 0 || values[ParameterId::chatter] > 0;
}

SampleTask taskOfKeys(SampledInstrument sampled,
                      std::span<const int> keys,
                      const SampleChoices& choices,
                      const std::string& ending) {
    return {.sampled = std::move(sampled), .ending = ending, .keys = planSamples(keys, choices)};
}

Result<SampleTask> taskOfPlaces(SampledInstrument sampled,
                                std::size_t slot,
                                std::size_t places,
                                int velocities,
                                const std::string& ending) {
    const auto& object = *sampled.instrument->slots()[slot].object;
    const auto rows = spreadPlaces(object, places);
    if (!rows)
        return tl::unexpected(rows.error());
    const ObjectSurface surface(object);
    SampleTask task{.sampled = std::move(sampled), .ending = ending};
    for (std::size_t place = 0; place < rows->size(); ++place) {
        const auto row = (*rows)[place];
        const auto point = surface.atVertex(object.shapeVertices[row]);
        for (const int velocity : layerVelocities(velocities)) {
            std::array<char, 48> name{};
            std::snprintf(name.data(), name.size(), "p%02zu-v%03d", place + 1, velocity);
            task.places.push_back(
                {.strike = {.slot = slot, .point = point.value(), .velocity = velocity},
                 .placeMetres = vertexOfRow(object, row),
                 .name = name.data()});
        }
    }
    return task;
}

} // namespace idiophone
