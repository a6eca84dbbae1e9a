// Handling of a sound that is not finite. The instrument never makes one, so a test stage does.
#include "Support/TestSound.h"

#include <catch2/catch_test_macros.hpp>
#include <limits>

using namespace idiophone;
using namespace idiophone::test;

namespace {

constexpr int goodNote = 60, badNote = 61;

/// Plays a constant after each note, and NaN after the bad note.
class BreakingStage final : public Stage {
public:
    std::unique_ptr<StagePlayer> makePlayer(double, std::uint64_t) const override {
        return std::make_unique<Breaking>();
    }
    const std::string& objectOf(std::size_t) const override { return object; }
    std::span<const BodyPose> firstPoses() const override { return {&pose, 1}; }
    double delaySeconds() const override { return 0; }
    double lengthSeconds() const override { return 0; }

private:
    struct Breaking final : StagePlayer {
        void startNote(int midiNote, int, std::int64_t, double) noexcept override {
            sample = midiNote == badNote ? std::numeric_limits<float>::quiet_NaN() : sample + 0.1f;
        }
        void countNotesFrom(std::uint32_t) noexcept override {}
        void sound(std::int64_t, Synthesiser&, std::span<const CellOutput>) noexcept override {}
        void release(Synthesiser&, std::span<const CellOutput>) noexcept override {}
        void hear(std::span<const CellOutput>, const CellOutput& ears) noexcept override {
            for (std::size_t c = 0; c < ears.channels(); ++c)
                std::ranges::fill(ears[c], sample);
        }
        void reset() noexcept override { sample = 0; }
        bool silent() const noexcept override { return sample == 0; }
        std::span<const BodyPose> bodyPoses() const noexcept override { return {&pose, 1}; }
        float sample = 0;
        BodyPose pose;
    };

    std::string object = "plate";
    BodyPose pose;
};

Sound breakingSound() {
    std::array<int, 128> allOnOne{};
    Sound sound;
    sound.preset.name = "Breaks";
    sound.preset.keyMap = {.kind = KeyMapKind::scene, .object = "stage"};
    sound.instrument = Instrument::onStage(
        sound.preset.keyMap,
        {{.object = std::make_shared<const ModalObject>(syntheticObject({440}))}}, allOnOne,
        std::make_shared<BreakingStage>());
    return sound;
}

juce::MidiBuffer struck(int note) {
    juce::MidiBuffer midi;
    midi.addEvent(juce::MidiMessage::noteOn(1, note, juce::uint8{100}), 0);
    return midi;
}

} // namespace

TEST_CASE("A sound that is not finite becomes silence and is reported, and the next note sounds") {
    Processor processor;
    REQUIRE(processor.soundSession().playSound(breakingSound()));
    processor.prepareToPlay(testRateHz, testBlockSize);
    CHECK(loudest(render(processor, 4800, testBlockSize, struck(goodNote))) > 0.05f);
    CHECK(processor.engineReport().notFinite == 0);
    processor.poll();
    CHECK_FALSE(processor.view().status.takeStatus().isError);

    CHECK(loudest(render(processor, testBlockSize, testBlockSize, struck(badNote))) == 0);
    CHECK(processor.engineReport().notFinite == 1);
    CHECK(loudest(render(processor, 4800, testBlockSize, {})) == 0);
    CHECK(processor.engineReport().notFinite == 1); // the player has started again
    CHECK(loudest(render(processor, 4800, testBlockSize, struck(goodNote))) > 0.05f);
    CHECK(processor.engineReport().notFinite == 1);

    processor.poll();
    CHECK(processor.view().status.takeStatus().sentence.find("not finite") != std::string::npos);
}
