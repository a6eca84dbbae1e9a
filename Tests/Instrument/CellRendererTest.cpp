#include "Instrument/CellRenderer.h"
#include "Support/Level.h"
#include "Support/RenderNotes.h"
#include "Synth/SharedSurfaceProfile.h"
#include "TestInstruments.h"

#include <algorithm>
#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <tuple>
#include <vector>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Approx;

namespace {

constexpr double sampleRateHz = 48000;

/// A renderer of the bars, without a player.
struct Rig {
    explicit Rig(std::unique_ptr<CellStrategy> strategy = std::make_unique<MalletCells>())
        : renderer(*instrument, sampleRateHz, std::move(strategy), contacts, hand, input) {
        parameters.set(ParameterId::letRing, 0);
        parameters.set(ParameterId::releaseTime, 0.05);
        parameters.set(ParameterId::strikeSpread, 0);
    }

    void press(int note) { keys.follow(midi(0, 0x90, note, 100)); }
    void release(int note) { keys.follow(midi(0, 0x80, note, 0)); }
    void strike(int note) {
        strikes.strikeKey(instrument->key(note), 100, HeldContacts::controllerAtRest,
                          renderer.moment(parameters, 1));
    }
    void beginCell() { renderer.beginCell(parameters, keys, strikes); }
    /// Copies out the next samples in parts.
    std::vector<float> copy(std::size_t count, std::size_t part = cellSamples) {
        StereoSound sound(count);
        for (std::size_t at = 0; at < count;) {
            if (renderer.cellIsOver())
                beginCell();
            const auto length =
                std::min({part, count - at, static_cast<std::size_t>(renderer.samplesLeft())});
            const StereoSpan all = sound;
            renderer.copyOut({&all, 1}, at, at + length, {}, strikes);
            at += length;
        }
        return sound.left;
    }

    std::shared_ptr<const Instrument> instrument = bars();
    ParameterValues parameters;
    HeldContacts contacts{*instrument, sharedSurfaceProfile({}, sampleRateHz), 1};
    HandScrape hand{*instrument, sharedSurfaceProfile({}, sampleRateHz), 1,
                    std::vector<double>(instrument->slots().size(), 1)};
    InputForce input{*instrument, sampleRateHz, {}, HandScrape::firstFreeForce};
    KeyState keys{contacts};
    StrikeScheduler strikes{*instrument, 1};
    CellRenderer renderer;
};

/// A strategy that mixes a constant to the ears and records the notes.
class ConstantStage final : public StagePlayer {
public:
    using Note = std::tuple<int, int, std::int64_t, double>;

    void startNote(int note, int velocity, std::int64_t cell, double sample) noexcept override {
        notes.emplace_back(note, velocity, cell, sample);
    }
    void countNotesFrom(std::uint32_t) noexcept override {}
    void sound(std::int64_t, Synthesiser&, std::span<const CellOutput>) noexcept override {}
    void release(Synthesiser&, std::span<const CellOutput>) noexcept override {}
    void hear(std::span<const CellOutput> slots, const CellOutput& ears) noexcept override {
        slotOutputs = slots.size();
        std::ranges::fill(ears[0], 0.25f);
        std::ranges::fill(ears[1], 0.5f);
    }
    void reset() noexcept override {}
    bool silent() const noexcept override { return true; }

    std::vector<Note> notes;
    std::size_t slotOutputs = 0;
};

} // namespace

TEST_CASE("A renderer copies the same sound out in parts of any length") {
    const auto played = [](std::size_t part) {
        Rig rig;
        rig.press(69);
        rig.beginCell();
        rig.strike(69);
        return rig.copy(1000, part);
    };
    CHECK(played(1) == played(64));
    CHECK(played(37) == played(64));
    CHECK(peak(played(64)) > 0);
}

TEST_CASE("A damper falls on a slot when its key goes up, unless a hand touches it") {
    Rig released, touched;
    for (auto* rig : {&released, &touched}) {
        rig->press(69);
        rig->beginCell();
        rig->strike(69);
        rig->copy(640);
        rig->release(69);
    }
    touched.renderer.dampers().touch(static_cast<std::size_t>(touched.instrument->key(69).slot),
                                     true);
    const auto damped = released.copy(4800), ringing = touched.copy(4800);
    CHECK(rms(std::span(damped).last(480)) < 0.01 * rms(std::span(ringing).last(480)));
    touched.renderer.liftHands();
    const auto lifted = touched.copy(4800);
    CHECK(rms(std::span(lifted).last(480)) < 0.01 * rms(std::span(ringing).last(480)));
}

TEST_CASE("The first gain acts at once, and a later one within 10 ms in small steps") {
    Rig plain, loud;
    for (auto* rig : {&plain, &loud}) {
        rig->press(69);
        rig->beginCell();
        rig->strike(69);
    }
    loud.renderer.moveGain(2);
    const auto expected = plain.copy(cellSamples), sound = loud.copy(cellSamples);
    for (std::size_t k = 0; k < cellSamples; ++k)
        CHECK(sound[k] == 2 * expected[k]);
    float fraction = 1;
    for (int cell = 0; cell < 60; ++cell) {
        plain.beginCell();
        loud.beginCell();
        loud.renderer.moveGain(1);
        const float now = loud.copy(cellSamples).back() / plain.copy(cellSamples).back() - 1;
        CHECK(now <= fraction);
        CHECK(now >= 0.8f * fraction - 1e-4f);
        fraction = now;
    }
    CHECK(fraction < 1e-4f);
}

TEST_CASE("A silenced sound fades out over one cell and never returns") {
    Rig rig;
    rig.press(69);
    rig.beginCell();
    rig.strike(69);
    const auto before = rig.copy(640);
    rig.renderer.silence();
    rig.renderer.endSilence(rig.parameters, rig.keys);
    CHECK_FALSE(rig.renderer.silent());
    const auto fading = rig.copy(cellSamples);
    CHECK(std::abs(fading[0] - before.back()) < 0.1f * peak(before));
    CHECK(std::abs(fading.back()) < 0.01f * peak(before));
    CHECK(peak(rig.copy(4800)) == 0);
    CHECK(rig.renderer.silent());
}

TEST_CASE("A reset renderer plays like a new one") {
    const auto play = [](Rig& rig) {
        rig.press(69);
        rig.beginCell();
        rig.renderer.moveGain(0.5f);
        rig.strike(69);
        return rig.copy(1000, 100);
    };
    Rig rig;
    const auto first = play(rig);
    rig.renderer.reset();
    rig.strikes.reset();
    CHECK(play(rig) == first);
}

TEST_CASE("On a stage a renderer plays the ears' mix of separate slots") {
    ConstantStage stage;
    Rig rig(std::make_unique<StageCells>(stage));
    StereoSound sound(cellSamples);
    rig.beginCell();
    const StereoSpan all = sound;
    rig.renderer.copyOut({&all, 1}, 0, 10, {}, rig.strikes);
    CHECK(stage.slotOutputs == rig.instrument->slots().size());
    CHECK(sound.left[9] == 0.25f);
    CHECK(sound.right[9] == 0.5f);
    rig.renderer.startNote(stage, 60, 80);
    CHECK(stage.notes == std::vector{ConstantStage::Note(60, 80, 0, 10)});
    CHECK(rig.renderer.moment(rig.parameters, 1).sample ==
          cellSamples); // the ears have heard this cell
}
