// Tests messages pending between threads when their instrument is destroyed. They must not act on
// another instrument that is later placed at the same address.
#include "Instrument/ObjectLibrary.h"
#include "Instrument/SilencedModes.h"
#include "Plugin/ModeSilencer.h"
#include "Plugin/SoundMonitor.h"
#include "Plugin/StageCapture.h"
#include "Plugin/SurfaceHand.h"
#include "Support/Level.h"
#include "Support/RenderNotes.h"
#include "Support/SyntheticObject.h"
#include "Support/TestFolder.h"

#include <catch2/catch_test_macros.hpp>
#include <new>

using namespace idiophone;
using namespace idiophone::test;

namespace {

constexpr double sampleRateHz = 48000;

/// Places instruments one after the other at one address.
class OneAddress {
public:
    std::shared_ptr<const Instrument> place(const Instrument& like) {
        return {new (storage) Instrument(like),
                [](Instrument* placed) { std::destroy_at(placed); }};
    }

private:
    alignas(Instrument) std::byte storage[sizeof(Instrument)];
};

/// Returns a new instrument of the same object at each call.
std::shared_ptr<const Instrument> keys() {
    static ObjectLibrary library;
    static const auto kept = library.add("plate", syntheticObject({440}));
    return Instrument::build(
               {.kind = KeyMapKind::zones, .lowestNote = 60, .highestNote = 72, .object = "plate"},
               library)
        .value();
}

/// Strikes one slot over and over.
class StrikingStage final : public Stage {
public:
    explicit StrikingStage(std::size_t slot) : struck{.slot = slot, .strike = {}} {}

    std::unique_ptr<StagePlayer> makePlayer(double, std::uint64_t) const override {
        return std::make_unique<Striking>(struck);
    }
    const std::string& objectOf(std::size_t) const override { return object; }
    std::span<const BodyPose> firstPoses() const override { return {}; }
    double delaySeconds() const override { return 0; }
    double lengthSeconds() const override { return 0; }

private:
    struct Striking final : StagePlayer {
        explicit Striking(const PlacedImpact& impact) : struck(impact) {}
        void startNote(int, int, std::int64_t, double) noexcept override {}
        void countNotesFrom(std::uint32_t) noexcept override {}
        void sound(std::int64_t, Synthesiser&, std::span<const CellOutput>) noexcept override {}
        void release(Synthesiser&, std::span<const CellOutput>) noexcept override {}
        void hear(std::span<const CellOutput>, const CellOutput&) noexcept override {}
        void reset() noexcept override {}
        bool silent() const noexcept override { return true; }
        std::span<const PlacedImpact> takeImpacts() noexcept override { return {&struck, 1}; }
        std::uint32_t number() const noexcept override { return 1; }
        PlacedImpact struck;
    };

    PlacedImpact struck;
    std::string object = "plate";
};

std::shared_ptr<const Instrument> stageOf(std::size_t slots) {
    const auto object = std::make_shared<const ModalObject>(syntheticObject({440}));
    std::array<int, 128> silentKeys;
    silentKeys.fill(-1);
    return Instrument::onStage({.kind = KeyMapKind::scene, .object = "stage"},
                               std::vector<SynthesiserSlot>(slots, {.object = object}), silentKeys,
                               std::make_shared<StrikingStage>(slots - 1));
}

} // namespace

TEST_CASE("A strike on a destroyed instrument does not reach another one at its address") {
    OneAddress address;
    WindowEvents events;
    SurfaceHand hand(events);
    hand.strike(address.place(*keys()), 0, {0, 0, 0}, 100);
    Player player(address.place(*keys()), sampleRateHz);
    events.read(&player, [](const MidiEvent&) {});
    CHECK(player.silent());
}

TEST_CASE("Modes silenced in a destroyed instrument are heard in another one at its address") {
    OneAddress address;
    const auto like = keys();
    ModeSilencer silencer;
    silencer.send(*address.place(*like),
                  {.objects = {{.object = like->slots()[0].object.get(), .isSilenced = {1}}}});
    const auto heard = [&](std::shared_ptr<const Instrument> instrument) {
        Player player(std::move(instrument), sampleRateHz);
        silencer.silence(&player);
        return peak(renderStereo(player, {midi(0, 0x90, 60, 100)}, 4800, 480).left) > 0;
    };
    CHECK(heard(address.place(*keys())));
}

TEST_CASE("Strikes of a destroyed scene are not kept for another one at its address") {
    OneAddress address;
    StageCapture capture;
    {
        Player player(address.place(*stageOf(2)), sampleRateHz);
        capture.take(player);
    }
    const auto other = address.place(*stageOf(1));
    capture.follow(other);
    CHECK(capture.count() == 0);
    CHECK_FALSE(capture.writeMidi(testFolder() / "none.mid", 120));

    Player player(other, sampleRateHz);
    capture.take(player);
    capture.follow(other);
    CHECK(capture.count() == 1);
}

TEST_CASE("The view of a destroyed instrument is not taken for another one at its address") {
    OneAddress address;
    Handoff<Player> handoff;
    PlayerCrossfade sound(handoff);
    SoundMonitor monitor;
    monitor.prepare(sampleRateHz);
    CHECK(monitor.take() == nullptr);
    const auto look = [&](std::shared_ptr<const Instrument> instrument) {
        sound.install(std::make_unique<Player>(std::move(instrument), sampleRateHz));
        const SoundMonitor::Callback callback(monitor, sound, 4800);
    };
    look(address.place(*keys()));
    sound.install(nullptr);
    const auto* seen = monitor.take();
    REQUIRE(seen != nullptr);
    const auto other = address.place(*keys());
    CHECK(seen->instrument != other->serialNumber());
    look(other);
    seen = monitor.take();
    REQUIRE(seen != nullptr);
    CHECK(seen->instrument == other->serialNumber());
}
