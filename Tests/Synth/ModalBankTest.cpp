// Tests the bank on every SIMD target of this machine.
#include "Synth/ModalBank.h"

#include "Support/Larger.h"
#include "Support/SimdTargets.h"

#include <array>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/generators/catch_generators_range.hpp>
#include <cmath>
#include <complex>
#include <numbers>
#include <random>
#include <vector>

using namespace idiophone;
using namespace idiophone::test;

namespace {

constexpr double sampleRate = 48000;
constexpr std::size_t modes = 337;
constexpr PoleLaw law{.damping = {.fluidPerSecond = 20, .viscoelasticSeconds = 1e-7}};

struct Reference {
    std::vector<double> eigenvalues;
    std::vector<std::complex<double>> poles;

    Reference() {
        std::mt19937 random(1);
        std::uniform_real_distribution<double> hz(20, 22000);
        for (std::size_t g = 0; g < modes; ++g) {
            const double omega = 2 * std::numbers::pi * hz(random);
            const double alpha = (20 + 1e-7 * omega * omega) / 2;
            eigenvalues.push_back(omega * omega);
            poles.emplace_back(-alpha, std::sqrt(omega * omega - alpha * alpha));
        }
    }
};

ModalBank ringingBank(const Reference& reference) {
    ModalBank bank(modes, 1, sampleRate);
    bank.movePoles(reference.eigenvalues, law, 20, 23000);
    for (std::size_t g = 0; g < modes; ++g)
        bank.setState(g, {1, -0.5});
    return bank;
}

std::vector<std::int32_t> allBlocks(const ModalBank& bank) {
    std::vector<std::int32_t> blocks(bank.blockCount());
    for (std::size_t b = 0; b < blocks.size(); ++b)
        blocks[b] = static_cast<std::int32_t>(b);
    return blocks;
}

} // namespace

TEST_CASE(
    "On every SIMD target a cell of the mixed modes equals complex exponentials within -120 dB") {
    const TargetInTurn turn(GENERATE(Catch::Generators::from_range(targetsHere())));
    const Reference reference;
    ModalBank bank = ringingBank(reference);
    std::vector<std::int32_t> mixed;
    for (std::size_t g = 0; g < modes; ++g)
        if (g % 7 != 1 && (g < 100 || g > 210))
            mixed.push_back(static_cast<std::int32_t>(g));
    std::vector<ModeRun> runs;
    findRuns(mixed, runs);
    const auto blocks = allBlocks(bank);
    alignas(64) std::array<float, 64> output;
    double worst = 0;
    for (int cell = 0; cell < 60; ++cell) {
        output.fill(0.25f);
        bank.render(blocks, runs, 1, {output.data(), nullptr});
        for (std::size_t k = 0; k < output.size(); ++k) {
            const double t = (64.0 * cell + static_cast<double>(k)) / sampleRate;
            double expected = 0.25;
            for (const std::int32_t g : mixed)
                expected += (std::complex<double>(1, -0.5) *
                             std::exp(reference.poles[static_cast<std::size_t>(g)] * t))
                                .real();
            worst = larger(worst, std::abs(static_cast<double>(output[k]) - expected));
        }
    }
    CHECK(worst < 1e-6 * static_cast<double>(mixed.size()));
    // Unmixed modes move on, too.
    const double t = 60 * 64 / sampleRate;
    const auto expected = std::complex<double>(1, -0.5) * std::exp(reference.poles[150] * t);
    CHECK(std::abs(bank.state(150).x - expected.real()) < 1e-11);
    CHECK(std::abs(bank.state(150).y - expected.imag()) < 1e-11);
    CHECK(std::abs(static_cast<double>(bank.energies()[150]) - std::norm(expected)) < 1e-6);
}

TEST_CASE("SIMD targets agree within -110 dB, and each repeats bit for bit") {
    const Reference reference;
    std::vector<std::vector<float>> renders;
    for (const std::int64_t target : targetsHere())
        for (int again = 0; again < 2; ++again) {
            const TargetInTurn turn(target);
            ModalBank bank = ringingBank(reference);
            const auto blocks = allBlocks(bank);
            const std::vector<ModeRun> runs{{0, static_cast<std::int32_t>(modes)}};
            auto& render = renders.emplace_back();
            alignas(64) std::array<float, 64> output;
            for (int cell = 0; cell < 2000; ++cell) {
                output.fill(0);
                bank.render(blocks, runs, 1, {output.data(), nullptr});
                render.insert(render.end(), output.begin(), output.end());
            }
        }
    double peak = 0;
    for (const float sample : renders.front())
        peak = larger(peak, std::abs(static_cast<double>(sample)));
    for (std::size_t r = 0; r < renders.size(); r += 2) {
        CHECK(renders[r] == renders[r + 1]);
        double worst = 0;
        for (std::size_t k = 0; k < renders[r].size(); ++k)
            worst = larger(worst, std::abs(static_cast<double>(renders[r][k]) -
                                           static_cast<double>(renders[0][k])));
        CHECK(worst < peak * 3.16e-6);
    }
}

TEST_CASE("Free motion is the same in cells, over any time and in samples within a cell") {
    const TargetInTurn turn(GENERATE(Catch::Generators::from_range(targetsHere())));
    const double damping = GENERATE(10.0, 5000.0, 30000.0);
    ModalBank bank(40, 1, 44100);
    const std::vector<double> eigenvalues(40, 4e6);
    bank.movePoles(eigenvalues, {.damping = {.fluidPerSecond = damping}}, 20, 20000);
    for (std::size_t g = 0; g < 40; ++g)
        bank.setState(g, {1, 0.3});
    const std::vector<std::int32_t> first{0};
    alignas(64) std::array<float, 64> output{};
    bank.render(first, {}, 1, {output.data(), nullptr});
    bank.advanceBlock(1, 64 / 44100.0, 1);
    CHECK(std::abs(bank.state(0).x - bank.state(20).x) < 1e-6);
    CHECK(std::abs(bank.state(0).y - bank.state(20).y) < 1e-6);
}

TEST_CASE(
    "State increments start and end between samples and join at whole samples, at any damping") {
    const TargetInTurn turn(GENERATE(Catch::Generators::from_range(targetsHere())));
    const double damping = GENERATE(10.0, 5000.0, 30000.0);
    const double hz = GENERATE(30.0, 3000.0, 19000.0);
    constexpr std::size_t alike = 40;
    constexpr std::size_t g = 38;
    constexpr double rate = 44100;
    ModalBank bank(alike, 1, rate);
    const std::vector<double> eigenvalues(alike, std::pow(2 * std::numbers::pi * hz, 2));
    bank.movePoles(eigenvalues, {.damping = {.fluidPerSecond = damping}}, 20, 20000);
    const std::size_t padded = bank.paddedSize();
    UnitContact unit(padded);
    ModeResidues residues;
    residues[0].resize(padded);
    StateIncrements increments(padded, 1);
    unit.x[g] = 1;
    unit.y[g] = 0.3f;
    residues[0].re[g] = 2;
    const auto motion = [&](double samples) { return propagator(bank.pole(g), samples / rate); };
    const ModalState one{1, static_cast<double>(0.3f)};
    const auto check = [&](const ModalState& found, const ModalState& expected) {
        CHECK(std::abs(found.x - expected.x) < 2e-6);
        CHECK(std::abs(found.y - expected.y) < 2e-6);
    };
    const auto increment = [&] { return ModalState{increments.x[0][g], increments.y[0][g]}; };

    const double part = GENERATE(0.0, 0.3, 0.95);
    increments.start(bank, unit, residues, {part, 0.5});
    const ModalState started = motion(part) * one;
    check(increment(), started);
    const double size = amplitudeBound(bank.pole(g), started);
    CHECK(std::abs(std::sqrt(static_cast<double>(increments.energies[g])) - size) < 2e-6);

    for (const double samples : {1e-3, 0.7, 16.0, 40.3}) {
        increments.finish(bank, unit, residues, {part, -0.25}, {samples / rate, samples, 0.5});
        const ModalState start = motion(part + samples) * one;
        const ModalState end = motion(part) * one;
        const double left = std::exp2(-0.5);
        check(increment(), {-0.5 * (end.x - left * start.x), -0.5 * (end.y - left * start.y)});
    }
    for (const double samples : {0.0, 1.0, 15.0, 37.0, 63.0, 64.0}) {
        increments.start(bank, unit, residues, {});
        bank.setState(g, {0.25, -0.5});
        bank.join(increments, {samples / rate, samples, 1});
        const ModalState joined = motion(samples) * one;
        check(bank.state(g), {0.25 + joined.x, -0.5 + joined.y});
        const double loud = amplitudeBound(bank.pole(g), bank.state(g));
        CHECK(std::abs(std::sqrt(static_cast<double>(bank.energies()[g])) - loud) < 2e-6);
    }
}

TEST_CASE("State increments of a contact much shorter than a period keep their precision") {
    const TargetInTurn turn(GENERATE(Catch::Generators::from_range(targetsHere())));
    constexpr double seconds = 1e-6;
    ModalBank bank(16, 1, 44100);
    bank.movePoles(std::vector<double>(16, std::pow(2 * std::numbers::pi * 30, 2)),
                   {.damping = {.fluidPerSecond = 3}}, 20, 20000);
    UnitContact unit(16);
    ModeResidues residues;
    StateIncrements increments(16, 1);
    residues[0].resize(16);
    std::ranges::fill(residues[0].re, 1.0f);
    unit.setForced(bank.poles(), {.contactSeconds = seconds});
    increments.finish(bank, unit, residues, {}, {seconds, seconds * 44100, 0});
    // The state after an impulse, half a contact later.
    const ModalState left = propagator(bank.pole(0), seconds / 2) *
                            stateOf(bank.pole(0), {.velocity = 1, .displacement = 0});
    CHECK(std::abs(static_cast<double>(increments.x[0][0]) - left.x) < 1e-6);
    CHECK(std::abs(static_cast<double>(increments.y[0][0]) - left.y) < 1e-6);
}

TEST_CASE("The phase stays exact over hours of rest") {
    ModalBank bank(1, 1, 48000);
    const double omega = 2 * std::numbers::pi * 15000.3;
    bank.movePoles(std::vector<double>{omega * omega}, {}, 20, 20000);
    bank.setState(0, {1, 0});
    bank.advanceBlock(0, 7200, 1);
    const double turns = 15000.3 * 7200;
    const double angle = 2 * std::numbers::pi * (turns - std::floor(turns));
    CHECK(std::abs(bank.state(0).x - std::cos(angle)) < 1e-5);
    CHECK(std::abs(bank.state(0).y - std::sin(angle)) < 1e-5);
}

TEST_CASE("Only lightly damped audible modes count as resonances") {
    ModalBank bank(3, 1, 48000);
    const auto squared = [](double hz) { return std::pow(2 * std::numbers::pi * hz, 2); };
    bank.movePoles(std::vector<double>{squared(10), squared(1000), squared(20000)},
                   {.damping = {.viscoelasticSeconds = 1e-6}}, 20, 23000);
    REQUIRE(bank.poles().resonances().size() ==
            1); // the highest decays by a factor e within three periods
    CHECK(std::abs(bank.poles().resonances()[0] - 1000) < 1e-2);
}

TEST_CASE("Regrouping keeps the total velocity, whether modes oscillate or not") {
    // The first two are near critical damping, on either side of the change of coordinates.
    const std::vector<double> eigenvalues{2.4e5, 2.6e5, 1e6, 4e6, 9e6};
    const PoleLaw heavy{.damping = {.fluidPerSecond = 1000}};
    ModalBank bank(5, 1, sampleRate);
    ModeStates room(bank.paddedSize(), 1);
    bank.movePoles(eigenvalues, heavy, 20, 23000);
    CHECK(isOscillating(bank.pole(0)) != isOscillating(bank.pole(1)));
    double velocity = 0;
    for (std::size_t g = 0; g < 5; ++g) {
        bank.setState(g, {1.0 + double(g), -0.5});
        velocity += bank.state(g).x;
    }
    const std::vector<ModeShare> merge{{0, 0, 1}, {1, 0, 1}, {2, 0, 1}, {3, 1, 1}, {4, 1, 1}};
    bank.regroup(2, merge, room);
    bank.movePoles(std::vector<double>{5e5, 6e6}, heavy, 20, 23000);
    CHECK(bank.size() == 2);
    CHECK(std::abs(bank.state(0).x + bank.state(1).x - velocity) < 1e-12);
    CHECK(bank.state(1).y == -1.0);
    bank.regroup(3, std::vector<ModeShare>{{0, 0, 0.25}, {0, 1, 0.75}, {1, 2, 1}}, room);
    bank.movePoles(std::vector<double>{2.4e5, 1e6, 6e6}, heavy, 20, 23000);
    CHECK(std::abs(bank.state(0).x + bank.state(1).x + bank.state(2).x - velocity) < 1e-12);
    CHECK(std::abs(bank.state(0).x - 6.0 / 4) < 1e-12);
    // The states of removed modes are zero.
    for (std::size_t g = 3; g < modeBlock; ++g)
        CHECK(bank.energies()[g] == 0.0f);
}

namespace {

/// Many modes in one bank, and each of them in a separate bank.
class BankAndBanks {
public:
    static constexpr std::size_t count = 601;
    static constexpr std::size_t channels = 2;

    BankAndBanks() {
        alone.reserve(count);
        for (std::size_t g = 0; g < count; ++g)
            alone.emplace_back(1, channels, sampleRate);
        for (const std::size_t c : {0u, 1u}) {
            together.setChannels(channels);
            residues[c].resize(together.paddedSize());
            residueAlone[c].resize(modeBlock);
        }
        std::mt19937 random(7);
        std::uniform_real_distribution<double> hz(20, 22000), any(-1, 1);
        for (std::size_t g = 0; g < count; ++g) {
            eigenvalues.push_back(std::pow(2 * std::numbers::pi * hz(random), 2));
            alone[g].setChannels(channels);
            for (std::size_t c = 0; c < channels; ++c) {
                starts[c].push_back({any(random), any(random)});
                residues[c].re[g] = static_cast<float>(any(random));
                residues[c].im[g] = static_cast<float>(any(random));
                increments.x[c][g] = static_cast<float>(any(random));
                increments.y[c][g] = static_cast<float>(any(random));
            }
        }
    }

    /// Returns the number of modes that do not oscillate.
    std::size_t damp(double viscoelasticSeconds) {
        const PoleLaw damped{.damping = {.viscoelasticSeconds = viscoelasticSeconds}};
        together.movePoles(eigenvalues, damped, 20, 23000);
        std::size_t heavy = 0;
        for (std::size_t g = 0; g < count; ++g) {
            alone[g].movePoles(std::span(eigenvalues).subspan(g, 1), damped, 20, 23000);
            heavy += isOscillating(together.pole(g)) ? 0 : 1;
        }
        return heavy;
    }

    void begin() {
        for (std::size_t g = 0; g < count; ++g)
            for (std::size_t c = 0; c < channels; ++c) {
                together.setState(g, starts[c][g], c);
                alone[g].setState(0, starts[c][g], c);
            }
    }

    /// Renders every third block; the others rest and follow by advanceBlock.
    void move() {
        std::vector<std::int32_t> sounding;
        std::array<std::array<float, cellSize>, channels> output{};
        const ChannelOutputs outputs{output[0].data(), output[1].data()};
        for (std::size_t b = 0; b < together.blockCount(); ++b)
            if (b % 3 == 0)
                sounding.push_back(static_cast<std::int32_t>(b));
            else
                together.advanceBlock(b, 3 * cellSize / sampleRate, 0.5);
        together.render(sounding, {}, 0.5, outputs);
        for (std::size_t g = 0; g < count; ++g)
            if (g / modeBlock % 3 == 0)
                alone[g].render(alone[g].allBlocks(), {}, 0.5, outputs);
            else
                alone[g].advanceBlock(0, 3 * cellSize / sampleRate, 0.5);
    }

    /// Adds state increments and a force.
    void press() {
        const IncrementMove way{7 / sampleRate, 7, 0.25};
        std::array<float, cellSize> impulses;
        for (std::size_t k = 0; k < cellSize; ++k)
            impulses[k] = 1e-3f * static_cast<float>(k);
        together.join(increments, way);
        together.force(impulses, residues, residues, 3);
        for (std::size_t g = 0; g < count; ++g) {
            take(g);
            alone[g].join(incrementsAlone, way);
            alone[g].force(impulses, residueAlone, residueAlone, 3);
        }
    }

    bool areAlike() const {
        for (std::size_t g = 0; g < count; ++g) {
            for (std::size_t c = 0; c < channels; ++c)
                if (together.state(g, c).x != alone[g].state(0, c).x ||
                    together.state(g, c).y != alone[g].state(0, c).y)
                    return false;
            if (together.energies()[g] != alone[g].energies()[0])
                return false;
        }
        return true;
    }

    /// Compares mode by mode, because adding up all modes would round.
    bool soundAlike() {
        for (std::size_t g = 0; g < count; ++g) {
            std::array<std::array<float, cellSize>, 2 * channels> output{};
            take(g);
            auto one = together.emptyIncrements();
            for (std::size_t c = 0; c < channels; ++c) {
                one.x[c][g] = increments.x[c][g];
                one.y[c][g] = increments.y[c][g];
            }
            one.sound(together, std::vector<ModeRun>{{0, count}}, subBlocks,
                      {output[0].data(), output[1].data()});
            incrementsAlone.sound(alone[g], std::vector<ModeRun>{{0, 1}}, subBlocks,
                                  {output[2].data(), output[3].data()});
            if (output[0] != output[2] || output[1] != output[3])
                return false;
        }
        return true;
    }

private:
    void take(std::size_t g) {
        for (std::size_t c = 0; c < channels; ++c) {
            incrementsAlone.x[c][0] = increments.x[c][g];
            incrementsAlone.y[c][0] = increments.y[c][g];
            residueAlone[c].re[0] = residues[c].re[g];
            residueAlone[c].im[0] = residues[c].im[g];
        }
    }

    std::vector<double> eigenvalues;
    std::array<std::vector<ModalState>, channels> starts;
    ModalBank together{count, channels, sampleRate};
    std::vector<ModalBank> alone;
    StateIncrements increments = together.emptyIncrements(), incrementsAlone{modeBlock, channels};
    ModeResidues residues, residueAlone;
};

} // namespace

TEST_CASE("Each of many modes moves as if alone, bit for bit, over-damped or not") {
    const TargetInTurn turn(GENERATE(Catch::Generators::from_range(targetsHere())));
    BankAndBanks banks;
    // Oscillating modes cross the limit to over-damping in both directions.
    for (const double viscoelasticSeconds : {3e-5, 1e-3, 3e-5, 1e-7, 1.5e-5}) {
        const std::size_t heavy = banks.damp(viscoelasticSeconds);
        CHECK((heavy == 0) == (viscoelasticSeconds == 1e-7));
        CHECK(heavy < BankAndBanks::count);
        banks.begin();
        for (int cell = 0; cell < 3; ++cell) {
            banks.move();
            CHECK(banks.areAlike());
            banks.press();
            CHECK(banks.areAlike());
        }
        CHECK(banks.soundAlike());
    }
}
