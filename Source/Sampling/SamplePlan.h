// Says which strikes of an instrument become samples, and which keys and velocities play each.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace idiophone {

struct SampleChoices {
    int every = 1;       ///< samples every nth of the keys, from the lowest on
    int velocities = 5;  ///< layers of velocity, 1 to 127
    int roundRobins = 1; ///< different strikes that take turns, 1 or more
};

/// A sample and the notes that play it.
struct PlannedSample {
    int key = 0;            ///< the key that is struck, 0 to 127
    int lowestKey = 0;      ///< of those that play it, resampled
    int highestKey = 0;     ///< at least `lowestKey`
    int velocity = 0;       ///< of the strike, and the highest that plays it, 1 to 127
    int lowestVelocity = 0; ///< the lowest that plays it
    int roundRobin = 1;     ///< its turn, from 1 on
    std::string name = {};  ///< of its file without the ending, such as "060-C4-v127-r1"
};

/// Returns the highest velocity of each layer, which is the one that is sampled, up to 127.
std::vector<int> layerVelocities(int layers);

/// Plans the samples of these keys, which are in rising order: by key, then velocity, then turn.
/// Keys without a sample of their own play the nearest one.
std::vector<PlannedSample> planSamples(std::span<const int> keys, const SampleChoices& choices);

} // namespace idiophone
