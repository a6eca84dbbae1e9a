#include "Sampling/SamplePlan.h"

#include <array>
#include <cstdio>

namespace idiophone {
namespace {

constexpr int highestVelocity = 127;

std::string nameOfSample(int key, int velocity, int roundRobin) {
    constexpr std::array notes{"C", "Cs", "D", "Ds", "E", "F", "Fs", "G", "Gs", "A", "As", "B"};
    std::array<char, 48> name{};
    std::snprintf(name.data(), name.size(), "%03d-%s%d-v%03d-r%d", key,
                  notes[static_cast<std::size_t>(key % 12)], key / 12 - 1, velocity, roundRobin);
    return name.data();
}

} // namespace

std::vector<int> layerVelocities(int layers) {
    std::vector<int> highest;
    for (int layer = 1; layer <= layers; ++layer)
        highest.push_back((highestVelocity * layer + layers / 2) / layers);
    return highest;
}

std::vector<PlannedSample> planSamples(std::span<const int> keys, const SampleChoices& choices) {
    std::vector<int> struck;
    for (std::size_t i = 0; i < keys.size(); i += static_cast<std::size_t>(choices.every))
        struck.push_back(keys[i]);
    const auto velocities = layerVelocities(choices.velocities);
    std::vector<PlannedSample> plan;
    for (std::size_t i = 0; i < struck.size(); ++i) {
        const int lowest = i == 0 ? keys.front() : (struck[i - 1] + struck[i]) / 2 + 1;
        const int highest = i + 1 == struck.size() ? keys.back() : (struck[i] + struck[i + 1]) / 2;
        for (std::size_t layer = 0; layer < velocities.size(); ++layer)
            for (int turn = 1; turn <= choices.roundRobins; ++turn)
                plan.push_back({.key = struck[i],
                                .lowestKey = lowest,
                                .highestKey = highest,
                                .velocity = velocities[layer],
                                .lowestVelocity = layer == 0 ? 1 : velocities[layer - 1] + 1,
                                .roundRobin = turn,
                                .name = nameOfSample(struck[i], velocities[layer], turn)});
    }
    return plan;
}

} // namespace idiophone
