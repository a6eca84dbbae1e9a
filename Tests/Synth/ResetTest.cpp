// After a reset a synthesiser sounds bit for bit as a new one, whatever came before.
#include "ModalReference.h"

#include <catch2/catch_test_macros.hpp>
#include <random>

using namespace idiophone;
using namespace idiophone::test;

namespace {

constexpr double sampleRate = 48000;
constexpr std::size_t slots = 6, modes = 60;

/// Plays at random. The same seed plays the same on every synthesiser.
class RandomPlayer {
public:
    explicit RandomPlayer(unsigned seed) : random(seed) {}

    /// Sets every value that a reset keeps.
    void setEverything(Synthesiser& synthesiser) {
        synthesiser.setSettings(settings());
        for (std::size_t slot = 0; slot < slots; ++slot)
            for (int which = 0; which < 4; ++which)
                control(synthesiser, slot, which);
    }

    void play(Synthesiser& synthesiser, int cells, std::vector<float>& output) {
        for (int k = 0; k < cells; ++k) {
            changeSomething(synthesiser);
            synthesiser.beginCell(cell());
            actSomehow(synthesiser);
            for (const auto& channel : samples)
                output.insert(output.end(), channel.begin(), channel.end());
        }
    }

    /// Strikes and presses within the current cell.
    void actSomehow(Synthesiser& synthesiser) {
        for (unsigned k = chance(2) ? upTo(5) : 0; k > 0; --k) {
            if (chance(3))
                control(synthesiser, upTo(slots), static_cast<int>(upTo(4)));
            if (chance(5))
                press(synthesiser, upTo(slots));
            else
                synthesiser.strike(upTo(slots), strike(), between(0, 63.9), cell());
        }
    }

private:
    double between(double low, double high) {
        return low + (high - low) * static_cast<double>(random() % 10000) / 10000;
    }
    unsigned upTo(std::size_t count) { return static_cast<unsigned>(random() % count); }
    bool chance(unsigned oneIn) { return upTo(oneIn) == 0; }
    CellOutput cell() { return {samples[0], samples[1]}; }

    SynthesisSettings settings() {
        SynthesisSettings wanted;
        wanted.tau = chance(2) ? 0.01 : 0;
        wanted.modeBudget = chance(3) ? between(20, 200) : 4096;
        wanted.compression = between(0, 2);
        wanted.imperfection = chance(3) ? between(0, 0.01) : 0;
        wanted.sizeRatio = between(0.8, 1.2);
        wanted.radiation = chance(2) ? between(0, 1) : 0;
        if (chance(2))
            wanted.material = material();
        return wanted;
    }
    LiveMaterial material() {
        return {between(5e9, 2e10), between(800, 1200), {between(0, 200), between(0, 1e-5)}};
    }

    void control(Synthesiser& synthesiser, std::size_t slot, int which) {
        if (which == 0)
            synthesiser.setDamping(slot, chance(2) ? between(0, chance(2) ? 300 : 1e7) : 0);
        if (which == 1)
            synthesiser.setFrequencyRatio(slot, between(0.9, 1.1));
        if (which == 2)
            synthesiser.setMaterial(slot, chance(2) ? std::optional(material()) : std::nullopt);
        std::vector<std::uint8_t> silenced(modes);
        for (auto& is : silenced)
            is = chance(8) ? 1 : 0;
        if (which == 3)
            synthesiser.setSilencedModes(slot, chance(2) ? silenced : std::vector<std::uint8_t>{});
    }
    void changeSomething(Synthesiser& synthesiser) {
        if (chance(4))
            synthesiser.setSettings(settings());
        if (chance(2))
            control(synthesiser, upTo(slots), static_cast<int>(upTo(4)));
    }

    Strike strike() {
        Strike wanted = unitStrike(chance(3) ? 0 : between(5e-5, 5e-3));
        for (float& component : wanted.impulseNewtonSeconds)
            component = static_cast<float>(between(-1, 1) * (chance(3) ? 1e-3 : 1));
        return wanted;
    }
    void press(Synthesiser& synthesiser, std::size_t slot) {
        std::array<float, cellSamples> newtons{};
        for (float& force : newtons)
            force = static_cast<float>(between(0, 10));
        ForceCell force{.contact = upTo(3), .start = {}, .end = {}, .newtons = newtons};
        force.end.points[0].direction[0] = static_cast<float>(between(0, 1));
        synthesiser.applyForce(slot, force, cell());
    }

    std::minstd_rand random;
    std::array<std::array<float, cellSamples>, 2> samples{};
};

std::vector<std::complex<float>> radiationWeights() {
    std::minstd_rand random(7);
    std::vector<std::complex<float>> weights(2 * 3 * modes);
    for (auto& weight : weights)
        weight = std::polar(0.5f, static_cast<float>(random() % 100) / 16);
    return weights;
}

/// Modes of which more or fewer merge, depending on the settings.
std::vector<SynthesiserSlot> denseSlots() {
    std::vector<SynthesiserSlot> all;
    for (std::size_t slot = 0; slot < slots; ++slot) {
        std::vector<double> frequencies;
        for (std::size_t k = 0; k < modes; ++k)
            frequencies.push_back(200 + 90.0 * static_cast<double>(slot) +
                                  (k % 3 == 0 ? 40 : 0.9) * static_cast<double>(k));
        std::ranges::sort(frequencies);
        ModalObject object = ringingObject(frequencies, 20, std::vector<float>(modes, 0.5f));
        if (slot % 2 == 0)
            object.radiation = {.directions = {{0.8f, -0.6f, 0}, {0.8f, 0.6f, 0}},
                                .frequencyRatios = {0.5, 1, 2},
                                .weights = radiationWeights()};
        all.push_back(slotOf(std::move(object)));
    }
    return all;
}

} // namespace

TEST_CASE("After a reset a synthesiser sounds as a new one, whatever came before") {
    const auto all = denseSlots();
    for (unsigned seed = 1; seed <= 300; ++seed) {
        CAPTURE(seed);
        Synthesiser used(all, sampleRate, 2), fresh(all, sampleRate, 2);
        RandomPlayer history(seed);
        std::vector<float> before;
        history.play(used, 40, before);
        used.reset();
        if (seed % 3 == 0) { // another strike in the same cell, as after All Sound Off
            history.actSomehow(used);
            history.play(used, 5, before);
            used.reset();
        }
        std::vector<float> again, anew;
        for (const bool isUsed : {true, false}) {
            RandomPlayer player(1000 + seed);
            Synthesiser& synthesiser = isUsed ? used : fresh;
            player.setEverything(synthesiser);
            player.play(synthesiser, 40, isUsed ? again : anew);
        }
        REQUIRE(std::ranges::any_of(anew, [](float sample) { return sample != 0; }));
        const auto differ = std::ranges::mismatch(again, anew).in1 - again.begin();
        CHECK(differ == std::ssize(anew));
    }
}
