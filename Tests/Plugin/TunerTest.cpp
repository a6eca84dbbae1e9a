// Sources of tunings: files of the instance, MIDI messages and the state.
#include "Plugin/Tuner.h"

#include "Support/PoleFit.h"
#include "Support/TestFolder.h"
#include "Support/TestSound.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>
#include <fstream>
#include <vector>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Matchers::ContainsSubstring;

namespace {

constexpr double sampleRateHz = 48000;
constexpr int struckNote = 69;

std::filesystem::path written(const std::string& name, const std::string& text) {
    const auto file = testFolder() / name;
    std::ofstream(file) << text;
    return file;
}

const std::string sixSteps = "Six steps\n6\n200.\n400.\n600.\n800.\n1000.\n2/1\n";
const std::string from432 = "0\n0\n127\n60\n69\n432\n0\n";

/// Returns a MIDI Tuning Standard message: tunes `note` to the tempered `pitch` plus `share` /
/// 16383 of a semitone.
juce::MidiMessage singleNoteTuning(int note, int pitch, int share) {
    const juce::uint8 bytes[] = {0x7f,
                                 0x7f,
                                 0x08,
                                 0x02,
                                 0x00,
                                 0x01,
                                 static_cast<juce::uint8>(note),
                                 static_cast<juce::uint8>(pitch),
                                 static_cast<juce::uint8>(share >> 7),
                                 static_cast<juce::uint8>(share & 127)};
    return juce::MidiMessage::createSysExMessage(bytes, sizeof bytes);
}

/// Returns the frequency of note 69, struck now after an optional message at the same sample.
double struckHz(Processor& processor, double expectedHz, const juce::MidiMessage* message = {}) {
    juce::MidiBuffer midi;
    if (message != nullptr)
        midi.addEvent(*message, 0);
    midi.addEvent(juce::MidiMessage::noteOn(1, struckNote, juce::uint8{100}), 0);
    juce::AudioBuffer<float> sound(2, 24000);
    processor.processBlock(sound, midi);
    return fitPole({sound.getReadPointer(0), 24000}, sampleRateHz, expectedHz, 0.05).frequencyHz;
}

struct Prepared {
    Prepared() {
        restore(processor, testState());
        processor.prepareToPlay(sampleRateHz, 24000);
    }
    Processor processor;
};

} // namespace

TEST_CASE("A scale from a file tunes the keys until it is forgotten") {
    Prepared instance;
    auto& processor = instance.processor;
    CHECK(processor.view().tuning.tuningStatus().source == TuningStatus::Source::equal);
    processor.view().tuning.openTuning(written("six.scl", sixSteps));
    const auto status = processor.view().tuning.tuningStatus();
    CHECK(status.source == TuningStatus::Source::files);
    CHECK(status.scale == "Six steps");
    const double hertz = 440 * std::exp2(9 / 12.0); // nine steps of the scale above middle C
    CHECK(std::abs(cents(struckHz(processor, hertz), hertz)) < 0.5);
    processor.view().tuning.forgetTuning();
    CHECK(processor.view().tuning.tuningStatus().source == TuningStatus::Source::equal);
    CHECK(std::abs(cents(struckHz(processor, 440), 440)) < 0.5);
}

TEST_CASE("Opening and forgetting a tuning are steps of the history") {
    Prepared instance;
    auto& processor = instance.processor;
    auto& history = processor.windowSession().history;
    const auto scale = written("six.scl", sixSteps), mapping = written("from432.kbm", from432);
    processor.view().tuning.openTuning(scale);
    processor.view().tuning.openTuning(mapping);
    const auto tuned = processor.view().tuning.tuningStatus();
    CHECK(history.undoName() == "from432.kbm");
    history.undo();
    CHECK(processor.view().tuning.tuningStatus().scale == "Six steps");
    CHECK(processor.view().tuning.tuningStatus().mappingFile.empty());
    history.undo();
    CHECK(processor.view().tuning.tuningStatus().source == TuningStatus::Source::equal);
    CHECK(std::abs(cents(struckHz(processor, 440), 440)) < 0.5);
    CHECK_FALSE(history.canUndo());
    history.redo();
    history.redo();
    CHECK(processor.view().tuning.tuningStatus() == tuned);
    CHECK(std::abs(cents(struckHz(processor, 432), 432)) < 0.5);

    processor.view().tuning.forgetTuning();
    CHECK(history.undoName() == "Forget tuning");
    history.undo();
    CHECK(processor.view().tuning.tuningStatus() == tuned);
    // A change without effect is no step.
    processor.view().tuning.openTuning(scale);
    processor.view().tuning.openTuning(written("damaged.scl", "no scale"));
    CHECK(history.undoName() == "from432.kbm");
    CHECK(history.redoName() == "Forget tuning");
}

TEST_CASE("Scale and mapping open from separate files, one after the other") {
    Prepared instance;
    auto& processor = instance.processor;
    processor.view().tuning.openTuning(written("from432.kbm", from432));
    CHECK(std::abs(cents(struckHz(processor, 432), 432)) < 0.5);
    processor.view().tuning.openTuning(written("six.scl", sixSteps));
    CHECK(std::abs(cents(struckHz(processor, 432), 432)) < 0.5);
    CHECK(processor.view().tuning.tuningStatus().mappingFile == "from432.kbm");
}

TEST_CASE("A file that cannot be read leaves the tuning unchanged and is named in the status") {
    Prepared instance;
    auto& processor = instance.processor;
    processor.view().tuning.openTuning(written("six.scl", sixSteps));
    const auto before = saved(processor);
    for (const auto& file : {written("bad.scl", "title\n2\nhello\n"), written("none.kbm", ""),
                             testFolder() / "missing.scl"}) {
        processor.view().tuning.openTuning(file);
        const auto status = processor.view().status.takeStatus();
        CHECK(status.isError);
        CHECK_THAT(status.sentence, ContainsSubstring(file.filename().string()));
    }
    CHECK(saved(processor) == before);
}

TEST_CASE("Program changes keep the tuning, and the state saves it unchanged") {
    Prepared first, second;
    first.processor.view().tuning.openTuning(written("six.scl", sixSteps));
    first.processor.view().tuning.openTuning(written("from432.kbm", from432));
    first.processor.setCurrentProgram(1);
    CHECK(first.processor.view().tuning.tuningStatus().source == TuningStatus::Source::files);
    restore(first.processor, [&] {
        auto state = *parseState(saved(first.processor));
        auto keyboard = testState();
        keyboard.tuning = state.tuning;
        return keyboard;
    }());
    const auto state = saved(first.processor);
    restoreBytes(second.processor, state);
    CHECK(saved(second.processor) == state);
    CHECK(std::abs(cents(struckHz(second.processor, 432), 432)) < 0.5);
    restore(second.processor, testState()); // a state without a tuning resets it
    CHECK(std::abs(cents(struckHz(second.processor, 440), 440)) < 0.5);
}

TEST_CASE("A state whose tuning cannot be read leaves the current sound unchanged") {
    Prepared instance;
    const auto before = instance.processor.soundSession().loadedSound();
    auto state = testState();
    state.tuning.scale = {.name = "old.scl", .text = "title\nmany\n"};
    restore(instance.processor, state);
    CHECK(instance.processor.soundSession().loadedSound() == before);
    CHECK_THAT(instance.processor.view().status.takeStatus().sentence,
               ContainsSubstring("old.scl"));
}

TEST_CASE("MIDI messages tune at their sample, at any block size") {
    juce::MidiBuffer midi;
    const auto up = singleNoteTuning(struckNote, 70, 8192),
               back = singleNoteTuning(struckNote, 69, 0);
    midi.addEvent(juce::MidiMessage::noteOn(1, struckNote, juce::uint8{100}), 100);
    midi.addEvent(up, 3000);
    midi.addEvent(juce::MidiMessage::noteOn(1, struckNote, juce::uint8{90}), 3000);
    midi.addEvent(back, 3000);
    midi.addEvent(up, 9001);
    midi.addEvent(juce::MidiMessage::controllerEvent(1, 64, 127), 9001);
    const auto played = [&](int blockSize) {
        Prepared instance;
        return render(instance.processor, 20000, blockSize, midi).left;
    };
    const auto expected = played(64);
    for (const int blockSize : {1, 777, 4096, 20000})
        CHECK(played(blockSize) == expected);
    Prepared instance;
    const auto plain = [&] {
        juce::MidiBuffer notes;
        notes.addEvent(juce::MidiMessage::noteOn(1, struckNote, juce::uint8{100}), 100);
        notes.addEvent(juce::MidiMessage::noteOn(1, struckNote, juce::uint8{90}), 3000);
        return render(instance.processor, 20000, 512, notes).left;
    }();
    CHECK(std::equal(plain.begin(), plain.begin() + 9001, expected.begin()));
    CHECK_FALSE(std::equal(plain.begin() + 9100, plain.end(), expected.begin() + 9100));
}

TEST_CASE("A tuning message in a block without samples takes effect afterwards") {
    Prepared instance;
    juce::MidiBuffer midi;
    midi.addEvent(singleNoteTuning(struckNote, 70, 8192), 0);
    midi.addEvent(singleNoteTuning(60, 61, 0), 0);
    juce::AudioBuffer<float> nothing(2, 0);
    instance.processor.processBlock(nothing, midi);
    const double hertz = 440 * std::exp2(1.5 / 12);
    CHECK(std::abs(cents(struckHz(instance.processor, hertz), hertz)) < 0.5);
}

TEST_CASE("A message outside the tuning standard tunes nothing") {
    Prepared instance;
    juce::MidiBuffer midi;
    const juce::uint8 reset[] = {0x7e, 0x7f, 0x09, 0x01};
    midi.addEvent(juce::MidiMessage::createSysExMessage(reset, sizeof reset), 0);
    render(instance.processor, 512, 512, midi);
    CHECK(instance.processor.view().tuning.tuningStatus().source == TuningStatus::Source::equal);
    midi.clear();
    midi.addEvent(singleNoteTuning(60, 61, 0), 0);
    render(instance.processor, 512, 512, midi);
    CHECK(instance.processor.view().tuning.tuningStatus().source == TuningStatus::Source::messages);
}

TEST_CASE("MIDI Tuning Standard messages tune keys unless the instance has a tuning") {
    Prepared instance;
    auto& processor = instance.processor;
    const auto message = singleNoteTuning(struckNote, 70, 8192); // half a semitone above B flat
    const double hertz = 440 * std::exp2(1.5 / 12);
    CHECK(std::abs(cents(struckHz(processor, hertz, &message), hertz)) < 0.5);
    processor.view().tuning.openTuning(written("from432.kbm", from432));
    CHECK(std::abs(cents(struckHz(processor, 432), 432)) < 0.5);
    processor.view().tuning.forgetTuning();
    CHECK(std::abs(cents(struckHz(processor, hertz), hertz)) < 0.5);
}

TEST_CASE("Keys that a message marks as unchanged keep their pitch, also within a bulk dump") {
    Prepared instance;
    const auto noChange = singleNoteTuning(struckNote, 127, 16383);
    CHECK(std::abs(struckHz(instance.processor, 440, &noChange) / 440 - 1) < 1e-3);
    const auto tuned = singleNoteTuning(struckNote, 70, 0);
    const double higherHz = 440 * std::exp2(1.0 / 12);
    CHECK(std::abs(struckHz(instance.processor, higherHz, &tuned) / higherHz - 1) < 1e-3);
    CHECK(std::abs(struckHz(instance.processor, higherHz, &noChange) / higherHz - 1) < 1e-3);

    const bool isOfBank = GENERATE(false, true);
    std::vector<juce::uint8> dump{0x7e, 0x7f, 0x08, 0x01, 0x00};
    if (isOfBank)
        dump = {0x7e, 0x7f, 0x08, 0x04, 0x00, 0x00};
    dump.insert(dump.end(), 16, 'n');
    for (juce::uint8 key = 0; key < 128; ++key) {
        const bool isLeft = key == struckNote;
        dump.insert(dump.end(), {isLeft ? juce::uint8{127} : key, juce::uint8(isLeft ? 127 : 32),
                                 juce::uint8(isLeft ? 127 : 0)});
    }
    dump.push_back(0); // the checksum, which is ignored
    const auto message =
        juce::MidiMessage::createSysExMessage(dump.data(), static_cast<int>(dump.size()));
    CHECK(std::abs(struckHz(instance.processor, higherHz, &message) / higherHz - 1) < 1e-3);
    dump[static_cast<std::size_t>(5 + (isOfBank ? 1 : 0) + 16 + 3 * struckNote)] = 68;
    dump[static_cast<std::size_t>(6 + (isOfBank ? 1 : 0) + 16 + 3 * struckNote)] = 0;
    dump[static_cast<std::size_t>(7 + (isOfBank ? 1 : 0) + 16 + 3 * struckNote)] = 0;
    const auto lower =
        juce::MidiMessage::createSysExMessage(dump.data(), static_cast<int>(dump.size()));
    const double lowerHz = 440 * std::exp2(-1.0 / 12);
    CHECK(std::abs(struckHz(instance.processor, lowerHz, &lower) / lowerHz - 1) < 1e-3);
}

TEST_CASE("A tuning by messages is not saved, and is reset by forgetTuning and by a state") {
    Prepared instance;
    auto& processor = instance.processor;
    const auto before = saved(processor);
    const auto up = singleNoteTuning(struckNote, 70, 8192);
    const auto other = singleNoteTuning(60, 61, 0);
    const double hertz = 440 * std::exp2(1.5 / 12);
    const auto isForgottenBy = [&](auto&& forget) {
        CHECK(std::abs(cents(struckHz(processor, hertz, &up), hertz)) < 0.5);
        CHECK(processor.view().tuning.tuningStatus().source == TuningStatus::Source::messages);
        CHECK(saved(processor) == before);
        forget();
        CHECK(processor.view().tuning.tuningStatus().source == TuningStatus::Source::equal);
        CHECK(std::abs(cents(struckHz(processor, 440), 440)) < 0.5);
        // The next message does not restore the forgotten tuning.
        CHECK(std::abs(cents(struckHz(processor, 440, &other), 440)) < 0.5);
        CHECK(processor.view().tuning.tuningStatus().source == TuningStatus::Source::messages);
    };
    isForgottenBy([&] { processor.view().tuning.forgetTuning(); });
    isForgottenBy([&] { restoreBytes(processor, before); });
}

TEST_CASE("A tuning message between forgetTuning and the next callback takes effect") {
    Prepared instance;
    const auto up = singleNoteTuning(struckNote, 70, 8192);
    const double hertz = 440 * std::exp2(1.5 / 12);
    instance.processor.view().tuning.forgetTuning();
    CHECK(std::abs(cents(struckHz(instance.processor, hertz, &up), hertz)) < 0.5);
    instance.processor.view().tuning.forgetTuning();
    CHECK(std::abs(cents(struckHz(instance.processor, hertz, &up), hertz)) < 0.5);
    CHECK(instance.processor.view().tuning.tuningStatus().source == TuningStatus::Source::messages);
}
