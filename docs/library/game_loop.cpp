// A game's loop with sound: a ball bounces on a modal object, a hundred frames a second. The game
// reports what hit what, when, where and how hard, and gets samples back.
//
//     game_loop OBJECT.modal SOUND.f32        (32-bit float, mono, 48 kHz)
#include "Object/ModalObjectFile.h"
#include "Synth/StrikePoints.h"
#include "Synth/Synthesiser.h"

#include <array>
#include <cmath>
#include <fstream>
#include <iostream>
#include <vector>

using namespace idiophone;

struct Impact {
    double seconds;
    float newtonSeconds;
};

/// A ball of 5 g, dropped from 20 cm, that keeps 80 % of its speed: what a physics engine would
/// say.
std::vector<Impact> impacts() {
    std::vector<Impact> all;
    double speed = std::sqrt(2 * 9.81 * 0.2), seconds = speed / 9.81;
    for (; speed > 0.05; speed *= 0.8, seconds += 2 * speed / 9.81)
        all.push_back({seconds, static_cast<float>(0.005 * 1.8 * speed)});
    return all;
}

int main(int count, char** arguments) {
    if (count != 3)
        return std::cerr << "game_loop OBJECT.modal SOUND.f32\n", 1;
    auto object = readModalObject(arguments[1]);
    if (!object)
        return std::cerr << object.error().message << '\n', 1;
    const auto shared = std::make_shared<const ModalObject>(std::move(*object));
    const StrikePoint point = StrikePoints(shared).nearest({0.05, 0.03, 0}); // where the ball hits

    constexpr double rateHz = 48000, frameSeconds = 0.01;
    Synthesiser synthesiser({{.object = shared}}, rateHz); // one slot a sounding body
    synthesiser.setSettings({.tau = 0.1, .modeBudget = 500});

    std::ofstream sound(arguments[2], std::ios::binary);
    const auto hits = impacts();
    std::size_t next = 0;
    std::int64_t cells = 0;
    for (int frame = 1; frame <= 300; ++frame) { // the game's, each with what happened in it
        for (; (cells + 1) * cellSamples <= frame * frameSeconds * rateHz; ++cells) {
            std::array<float, cellSamples> cell{};
            synthesiser.beginCell(cell); // what rings, for 64 samples
            for (; next < hits.size(); ++next) {
                const double sample = hits[next].seconds * rateHz - double(cells * cellSamples);
                if (sample >= cellSamples)
                    break;
                const Strike strike{.point = point,
                                    .impulseNewtonSeconds = {0, 0, -hits[next].newtonSeconds},
                                    .durationSeconds = 0.0005};
                synthesiser.strike(0, strike, std::max(sample, 0.0), cell); // at its own sample
            }
            sound.write(reinterpret_cast<const char*>(cell.data()), sizeof cell);
        }
    }
    return sound ? 0 : 1;
}
