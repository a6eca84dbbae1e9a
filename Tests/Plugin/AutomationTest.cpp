// Moves every parameter in one jump while something sounds, as a host does that sends one value a
// block. The sound must follow gradually, without a step.
#include "Parameters/ModulationTable.h"
#include "Support/Level.h"
#include "Support/TestSound.h"

#include <algorithm>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <complex>
#include <functional>
#include <iterator>
#include <numbers>
#include <numeric>
#include <span>
#include <utility>

using namespace idiophone;
using namespace idiophone::test;
using enum ParameterId;

namespace {

constexpr int cellSize = 64;
// At one turn a second the motor has closed the discs after a quarter of a second.
constexpr int struckCell = 150, releasedCell = 160, jumpCell = 188, endCell = 260;
// Largest allowed distance after the first and second 64 samples, as a fraction of the largest
// distance. A 10 ms glide has covered an eighth and a quarter by then, a jump the whole distance.
// Modes that end or return together are faded over 3 ms, which is 2.25 cells.
constexpr double mostAtOnce = 0.3, mostFaded = 0.8;
// Largest allowed sample above 14 kHz, as a fraction of the largest sample. No mode lies there, and
// a step leaves a hundredth or more. Rooms echo a strike's noise.
constexpr double mostOfStep = 0.002, mostOfStepInRoom = 0.02;
// A frequency that changes between two samples leaves a kink, not a step.
constexpr double mostOfKink = 0.006;

enum class Heard {
    asPole,    ///< changes the frequency and decay of ringing sound
    asLevel,   ///< changes the level of ringing sound
    ofImpacts, ///< changes later strikes only
};

struct Jump {
    ParameterId parameter;
    double from, to;
    Heard heard;
    std::vector<std::pair<ParameterId, double>> with = {};
    std::vector<juce::MidiMessage> played = {}; ///< sent with the chord
};

/// Objects of one mode, or of twelve modes in close pairs. Shapes differ over the surface,
/// radiation differs between the sides, and the thickness can be scaled.
State ringingState(bool inOneMode) {
    auto state = testState();
    state.objects.clear();
    for (int note = lowestTestNote; note <= highestTestNote; ++note) {
        std::vector<double> frequenciesHz;
        for (int mode = 0; mode < (inOneMode ? 1 : 12); ++mode)
            frequenciesHz.push_back(2000 * std::pow(1.2, mode / 2) * (1 + 0.002 * (mode % 2)) *
                                    std::exp2((note - lowestTestNote) / 12.0));
        const auto modes = frequenciesHz.size();
        auto object = syntheticObject(frequenciesHz, std::vector<float>(modes, 0.2f));
        for (std::size_t i = 0; i < object.shapes.size(); ++i)
            object.shapes[i] *= std::array{0.3f, 0.7f, 1.0f, 0.5f}[i / (3 * modes)];
        object.bending = object.eigenvalues;
        object.radiation = {.directions = {{0.8f, -0.6f, 0}, {0.8f, 0.6f, 0}},
                            .frequencyRatios = {1},
                            .weights = std::vector<std::complex<float>>(2 * modes, -0.1f)};
        std::fill_n(object.radiation.weights.begin(), modes, -0.3f);
        object.name = std::to_string(note);
        state.objects.push_back(
            {.name = "test/" + std::to_string(note), .modal = encodeModalObject(object)});
    }
    state.preset.parameters.set(material, customMaterial);
    state.preset.parameters.set(youngsModulus, 10);
    state.preset.parameters.set(density, 1000);
    state.preset.parameters.set(fluidDamping, 5);
    state.preset.parameters.set(viscoelasticDamping, 0.0001);
    state.preset.parameters.set(lossFactor, 0);
    state.preset.parameters.set(radiation, 100);
    state.preset.parameters.set(keepPitch, 0); // so that material values and sizes are heard
    state.preset.parameters.set(tau, parameterInfo(tau).minimum);
    return state;
}

class AutomatedHost {
public:
    AutomatedHost(State state, const Jump& jump) : moved(jump) {
        state.parameters = state.preset.parameters;
        for (const auto& [parameter, value] : jump.with)
            state.parameters.set(parameter, value);
        state.parameters.set(jump.parameter, jump.from);
        processor.setNonRealtime(true); // loudness is matched without a poll
        restore(processor, state);
        processor.prepareToPlay(testRateHz, cellSize);
    }

    void moveTo(double value) {
        processor.getParameters()[static_cast<int>(moved.parameter)]->setValue(
            static_cast<float>(parameterInfo(moved.parameter).toNormalised(value)));
    }

    HostSound cell(const std::vector<juce::MidiMessage>& messages = {}) {
        juce::MidiBuffer midi;
        for (const auto& message : messages)
            midi.addEvent(message, 0);
        return render(processor, cellSize, cellSize, midi);
    }

private:
    Processor processor;
    Jump moved;
};

juce::MidiMessage noteOn(int note, int velocity = 100) {
    return juce::MidiMessage::noteOn(1, note, static_cast<juce::uint8>(velocity));
}

using Cells = std::vector<HostSound>;

/// Cells of a chord, with or without the jump, from one cell before it on.
Cells ringing(const Jump& jump, bool jumps) {
    auto state = ringingState(jump.heard == Heard::asPole);
    if (jump.parameter == motorDepth || jump.parameter == motorSpeed)
        state = overTubes(std::move(state));
    AutomatedHost host(std::move(state), jump);
    Cells cells;
    for (int cell = 0; cell < endCell; ++cell) {
        if (cell == jumpCell && jumps)
            host.moveTo(jump.to);
        HostSound sound;
        if (cell == struckCell && jump.heard == Heard::asPole)
            sound = host.cell({noteOn(60)});
        else if (cell == struckCell) {
            auto messages = jump.played;
            messages.insert(messages.end(), {noteOn(60, 127), noteOn(64, 80), noteOn(67, 60)});
            sound = host.cell(messages);
        } else if (cell == releasedCell)
            sound = host.cell({juce::MidiMessage::noteOff(1, 60)});
        else
            sound = host.cell();
        if (cell >= jumpCell - 1)
            cells.push_back(std::move(sound));
    }
    return cells;
}

/// [1/s] Returns the pole of a single steady mode, from s(n+1) = 2 Re z s(n) − |z|² s(n−1).
std::complex<double> poleOf(const std::vector<float>& samples) {
    double aa = 0, ab = 0, bb = 0, ac = 0, bc = 0;
    for (std::size_t n = 1; n + 1 < samples.size(); ++n) {
        const double a = samples[n], b = -samples[n - 1], c = samples[n + 1];
        aa += a * a, ab += a * b, bb += b * b, ac += a * c, bc += b * c;
    }
    const double determinant = aa * bb - ab * ab;
    const double twiceReal = (ac * bb - bc * ab) / determinant;
    const double square = (aa * bc - ab * ac) / determinant;
    return testRateHz *
           std::log(std::complex(twiceReal / 2, std::sqrt(square - twiceReal * twiceReal / 4)));
}

/// Returns how far each cell is from the same cell without the jump.
std::vector<double> distances(const Jump& jump, const Cells& moved, const Cells& still) {
    std::vector<double> result;
    for (std::size_t cell = 0; cell < moved.size(); ++cell) {
        if (jump.heard == Heard::asPole) {
            result.push_back(std::abs(poleOf(moved[cell].left) - poleOf(still[cell].left)));
            continue;
        }
        auto difference = moved[cell].left;
        difference.insert(difference.end(), moved[cell].right.begin(), moved[cell].right.end());
        auto reference = still[cell].left;
        reference.insert(reference.end(), still[cell].right.begin(), still[cell].right.end());
        for (std::size_t i = 0; i < difference.size(); ++i)
            difference[i] -= reference[i];
        result.push_back(rms(difference));
    }
    return result;
}

/// Returns the largest sample above 14 kHz of the difference that the jump makes, as a fraction of
/// its largest sample. Only a step reaches that band. The filter is a windowed sinc.
double shareOfSteps(const Cells& moved, const Cells& still) {
    constexpr int reach = 32;
    constexpr double pi = std::numbers::pi, corner = 14000 / testRateHz;
    std::array<double, 2 * reach + 1> response{};
    for (int n = -reach; n <= reach; ++n) {
        const double sinc =
            n == 0 ? 1 - 2 * corner : -std::sin(2 * pi * corner * n) / (pi * n); // high-pass
        const double turn = pi * n / reach;
        response[static_cast<std::size_t>(n + reach)] =
            sinc * (0.35875 + 0.48829 * std::cos(turn) + 0.14128 * std::cos(2 * turn) +
                    0.01168 * std::cos(3 * turn)); // Blackman-Harris window
    }
    double largest = 0, largestHigh = 0;
    for (const auto side : {&HostSound::left, &HostSound::right}) {
        std::vector<double> change;
        for (std::size_t cell = 0; cell < moved.size(); ++cell)
            std::ranges::transform(moved[cell].*side, still[cell].*side, std::back_inserter(change),
                                   std::minus<double>());
        for (auto at = change.begin(); change.end() - at >= std::ssize(response); ++at) {
            largest = std::max(largest, std::abs(at[reach]));
            largestHigh =
                std::max(largestHigh,
                         std::abs(std::inner_product(response.begin(), response.end(), at, 0.0)));
        }
    }
    return largestHigh / largest;
}

constexpr auto asPole = Heard::asPole, asLevel = Heard::asLevel, ofImpacts = Heard::ofImpacts;

/// A route from velocity to this target, for the jumps of its parameters.
std::vector<std::pair<ParameterId, double>> byVelocity(ParameterId target) {
    return {{modulation1Source, static_cast<double>(ModulationSource::velocity)},
            {modulation1Target, modulationTargetChoice(target)},
            {modulation1Amount, -50}};
}

const std::vector<Jump> jumpsWhileRinging{
    {youngsModulus, 10, 12, asPole},
    {density, 1000, 1200, asPole},
    {fluidDamping, 5, 50, asPole},
    {viscoelasticDamping, 0.1, 0.4, asPole},
    {lossFactor, 0.001, 0.005, asPole},
    {decay, 1, 0.25, asPole},
    {size, 1, 1.1, asPole},
    {thickness, 100, 120, asPole},
    {tune, 0, 100, asPole},
    {concertPitch, 440, 460, asPole},
    {releaseTime, 1, 0.2, asPole, {{letRing, 0}}},
    {tau, 0.1, 1000, asLevel, {{fluidDamping, 100}}},
    {qualitySlope, 0, 10, asLevel, {{modeBudget, 16}}},
    {modeBudget, 16384, 16, asLevel},
    {compression, 0, 4, asLevel, {{fluidDamping, 100}}},
    {level, 0, -20, asLevel},
    {volume, 0, -20, asLevel},
    {brightness, -50, 50, asLevel},
    {width, 0, 200, asLevel},
    {room, 20, 100, asLevel},
    {roomDecay, 0.4, 10, asLevel, {{room, 100}}},
    {motorDepth, 0, 100, asLevel, {{motorSpeed, 1}}},
    {motorSpeed, 1, 12, asLevel, {{motorDepth, 100}}},
    {modulation1Amount, 0, -50, asLevel, byVelocity(level)},
    {modulation1Amount, 0, -50, asPole, byVelocity(decay)},
    {strikeAlong, -90, 90, ofImpacts},
    {strikeAcross, -90, 90, ofImpacts},
    {strikeSpread, 0, 100, ofImpacts},
    {hardness, 0, -100, ofImpacts},
    {malletHardness, 1000, 10, ofImpacts},
    {malletMass, 20, 100, ofImpacts},
    {malletSpeed, 3, 1, ofImpacts},
    {velocityCurve, 1, 4, ofImpacts},
    {malletRadius, 10, 50, ofImpacts},
    {malletExponent, 1.5, 2.5, ofImpacts},
    {malletFollow, 0, 100, ofImpacts},
    {chatter, 0, 100, ofImpacts},
    {radiation, 0, 100, ofImpacts},
    {mallet, customMallet, firstRackMallet, ofImpacts},
    {modalPulse, 0, 1, ofImpacts},
    {deadStroke, 0, 1, ofImpacts},
    {contact, strikeContact, scrapeContact, ofImpacts},
};

const std::vector<juce::MidiMessage> wheelUp{juce::MidiMessage::pitchWheel(1, 16383)};
const std::vector<juce::MidiMessage> bentOfItsOwn{juce::MidiMessage::pitchWheel(2, 16383),
                                                  juce::MidiMessage::noteOn(2, 62, 1.0f)};

/// Parameters without values in between, which cannot glide.
const std::vector<Jump> switchesWhileRinging{
    {material,
     customMaterial,
     firstLibraryMaterial,
     asLevel,
     {{youngsModulus, 21}, {lossFactor, 0.0043}}},
    {letRing, 1, 0, asLevel},
    {bendRange, 2, 3, asLevel, {}, wheelUp},
    {mpe, 0, 1, asLevel, {{mpeBendRange, 3}}, bentOfItsOwn},
    {mpeBendRange, 2, 3, asLevel, {{mpe, 1}}, bentOfItsOwn},
    {matchLoudness, 0, 1, asLevel, {{material, firstLibraryMaterial}}},
    {keepPitch, 0, 1, asLevel, {{size, 1.1}}},
    {modulation1Source, 0, static_cast<double>(ModulationSource::velocity), asLevel,
     byVelocity(level)},
    {modulation1Target, static_cast<double>(modulationTargetChoice(tune)),
     static_cast<double>(modulationTargetChoice(radiation)), asLevel, byVelocity(radiation)},
    {bypass, 0, 1, asLevel},
};

/// The effect of these parameters is measured as a level in decibels.
const std::vector<Jump> jumpsWhilePressed{
    {contactForce, 1, 30, asLevel},
    {contactSpeed, 0.25, 1, asLevel},
    {roughness, 0.25, 4, asLevel},
    {rollCoupling, 0, 100, asLevel, {{contact, rollContact}}},
    {strikeAlong, -90, 90, asLevel},
    {strikeAcross, -90, 90, asLevel},
    {radiation, 0, 100, asLevel, {{strikeAlong, -100}, {strikeAcross, -100}}},
    {thickness, 100, 200, asLevel},
};

/// Differences remove frequencies far below the mode's.
double energyOfSteps(const std::vector<float>& samples) {
    double sum = 0;
    for (std::size_t n = 1; n < samples.size(); ++n)
        sum += std::pow(samples[n] - samples[n - 1], 2);
    return sum;
}

/// Returns the level in decibels of each cell of a scrape or roll, averaged over many jumps. The
/// first cell is the one before the jump.
std::vector<double> pressedDb(const Jump& jump) {
    constexpr int repeats = 150, stay = 75; // cells
    auto state = ringingState(true);
    state.preset.parameters.set(fluidDamping, 1000); // so that the sound follows the force
    state.preset.parameters.set(contact, scrapeContact);
    AutomatedHost host(state, jump);
    host.cell({juce::MidiMessage::controllerEvent(1, 1, 127), noteOn(60, 127)});
    std::vector<double> energies(stay + 1);
    for (int repeat = 0; repeat < repeats; ++repeat) {
        host.moveTo(jump.from);
        for (int cell = 1; cell < stay; ++cell)
            host.cell();
        energies.front() += energyOfSteps(host.cell().left);
        host.moveTo(jump.to);
        for (std::size_t cell = 1; cell <= stay; ++cell)
            energies[cell] += energyOfSteps(host.cell().left);
    }
    for (auto& energy : energies)
        energy = 10 * std::log10(energy);
    return energies;
}

} // namespace

TEST_CASE("A parameter that the host moves while keys ring changes the sound gradually") {
    for (const auto& jump : jumpsWhileRinging) {
        if (jump.heard == ofImpacts)
            continue;
        const auto moved = ringing(jump, true), still = ringing(jump, false);
        const auto found = distances(jump, moved, still);
        const double farthest = *std::max_element(found.begin(), found.end());
        INFO(parameterInfo(jump.parameter).name);
        CAPTURE(found[1] / farthest, found[2] / farthest, farthest);
        CHECK(found[0] == 0);
        CHECK(farthest > 1e-6);
        CHECK(found[1] < mostAtOnce * farthest);
        CHECK(found[2] < (jump.parameter == tau ? mostFaded : mostAtOnce) * farthest);
        const bool isRoom = jump.parameter == room || jump.parameter == roomDecay;
        CHECK(shareOfSteps(moved, still) < (isRoom ? mostOfStepInRoom : mostOfStep));
        // For levels the beats of the chord hide the change from cell to cell.
        for (std::size_t cell = 1; jump.heard == asPole && cell < found.size(); ++cell)
            CHECK(std::abs(found[cell] - found[cell - 1]) < mostAtOnce * farthest);
    }
}

TEST_CASE("A switch that the host moves while keys ring leaves no step") {
    for (const auto& jump : switchesWhileRinging) {
        const auto moved = ringing(jump, true), still = ringing(jump, false);
        INFO(parameterInfo(jump.parameter).name);
        CHECK(distances(jump, moved, still).front() == 0);
        CHECK(moved != still);
        CHECK(shareOfSteps(moved, still) < mostOfKink);
    }
}

TEST_CASE("A strike parameter that the host moves leaves ringing sound unchanged") {
    for (const auto& jump : jumpsWhileRinging) {
        if (jump.heard != ofImpacts)
            continue;
        INFO(parameterInfo(jump.parameter).name);
        CHECK(ringing(jump, true) == ringing(jump, false));
        const auto nextImpact = [&](bool moves) {
            AutomatedHost host(ringingState(false), jump);
            if (moves)
                host.moveTo(jump.to);
            auto sound = host.cell({noteOn(60, 110)});
            for (int cell = 0; cell < 10; ++cell)
                sound.append(host.cell());
            return sound;
        };
        CHECK(nextImpact(true) != nextImpact(false));
    }
}

TEST_CASE("A parameter that the host moves during a scrape or roll changes the sound gradually") {
    for (const auto& jump : jumpsWhilePressed) {
        const auto found = pressedDb(jump);
        const double way = found.back() - found.front();
        CAPTURE(parameterInfo(jump.parameter).name, way);
        CHECK(std::abs(way) > 1);
        // Steps of the force must not click either.
        for (std::size_t cell = 1; cell <= 2; ++cell)
            CHECK(std::abs(found[cell] - found.front()) < mostAtOnce * std::abs(way));
    }
}

TEST_CASE("The jump tables cover every parameter that a host may move") {
    for (const auto& info : parameterTable()) {
        // Tested elsewhere: motorSync in HostSongTest, limiter in LimiterTest, outputs in
        // SlotOutputsTest, imperfection in ImperfectionTest, sound that comes in in InputForceTest
        // and DryWetTest, LFOs and the envelope in ModulationTest. All routes of modulation are
        // alike.
        const std::string_view group(info.group);
        if (info.parameter == motorSync || info.parameter == limiter || info.parameter == outputs ||
            info.parameter == imperfection || group == "Sound in" || group.starts_with("LFO") ||
            group == "Envelope" || group == "Modulation")
            continue;
        INFO(info.name);
        const auto isOfIt = [&](const Jump& jump) { return jump.parameter == info.parameter; };
        CHECK((std::ranges::any_of(jumpsWhileRinging, isOfIt) ||
               std::ranges::any_of(jumpsWhilePressed, isOfIt) ||
               std::ranges::any_of(switchesWhileRinging, isOfIt)));
    }
}
