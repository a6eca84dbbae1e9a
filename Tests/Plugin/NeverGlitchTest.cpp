// Actions in the window never make the sound click.
#include "Editor/EditorWindow.h"
#include "Geometry/MeshWriter.h"
#include "Geometry/ParametricMesh.h"
#include "Support/TestFolder.h"
#include "Support/TestSound.h"
#include "Support/WaitUntil.h"

#include <atomic>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <numbers>
#include <thread>

using namespace idiophone;
using namespace idiophone::test;

namespace {

constexpr int blockSize = 128;

/// Returns low, slowly decaying objects under a soft mallet, a smooth sound that would reveal a
/// click.
State smoothState(const std::string& folder) {
    auto state = testState(folder);
    state.objects.clear();
    for (int note = lowestTestNote; note <= highestTestNote; ++note) {
        const double frequencyHz = 110 * std::exp2((note - lowestTestNote) / 12.0);
        auto object = syntheticObject({frequencyHz}, {0.2f});
        object.name = folder + std::to_string(note);
        state.objects.push_back(
            {.name = folder + "/" + std::to_string(note), .modal = encodeModalObject(object)});
    }
    state.preset.parameters.set(ParameterId::malletHardness, 2);
    state.preset.parameters.set(ParameterId::malletMass, 200);
    state.parameters = state.preset.parameters;
    return state;
}

/// Plays on an audio thread without pause. Measures whether all samples are finite, their peak, and
/// the largest second difference.
class Listener {
public:
    explicit Listener(Processor& played) : processor(played) {
        thread = std::thread([this] { listen(); });
    }
    ~Listener() { finish(); }

    void finish() {
        stop = true;
        if (thread.joinable())
            thread.join();
    }

    std::atomic<int> blocks{0};
    bool finite = true;
    float loudest = 0, sharpest = 0; ///< read after `finish`

private:
    void listen() {
        juce::AudioBuffer<float> sound(2, blockSize);
        float before = 0, beforeThat = 0;
        for (int block = 0; !stop; ++block) {
            juce::MidiBuffer midi;
            if (block % 40 == 0)
                midi.addEvent(juce::MidiMessage::noteOn(1, lowestTestNote + block / 40 % 6,
                                                        static_cast<juce::uint8>(100)),
                              17);
            sound.clear();
            processor.processBlock(sound, midi);
            for (int i = 0; i < blockSize; ++i) {
                const float now = sound.getSample(0, i);
                finite = finite && std::isfinite(now) && processor.engineReport().notFinite == 0;
                loudest = std::max(loudest, std::abs(now));
                sharpest = std::max(sharpest, std::abs(now - 2 * before + beforeThat));
                beforeThat = before;
                before = now;
            }
            ++blocks;
        }
    }

    Processor& processor;
    std::atomic<bool> stop{false};
    std::thread thread;
};

void waitFor(const Listener& listener, int blocks) {
    const int until = listener.blocks + blocks;
    waitUntil([&] { return listener.blocks >= until; },
              [] { juce::Timer::callPendingTimersSynchronously(); });
}

float calmSharpness() {
    Processor processor;
    processor.prepareToPlay(testRateHz, blockSize);
    restore(processor, smoothState("smooth"));
    Listener listener(processor);
    waitFor(listener, 600);
    listener.finish();
    REQUIRE(listener.loudest > 0.01f);
    return listener.sharpest / listener.loudest;
}

} // namespace

TEST_CASE("Windows, presets, dropped meshes and undo during playback make no click") {
    const auto mesh = testFolder() / "plate.obj";
    REQUIRE(writeMesh(sheetMesh(0.3, 0.2, 200), mesh));
    const float calm = calmSharpness();

    Processor processor;
    processor.prepareToPlay(testRateHz, blockSize);
    restore(processor, smoothState("smooth"));
    Listener listener(processor);
    const auto other = smoothState("other"), first = smoothState("smooth");
    for (int round = 0; round < 12; ++round) {
        const std::unique_ptr<juce::AudioProcessorEditor> window(processor.createEditor());
        window->setSize(WindowSize::minimumWidth + 100 * round,
                        WindowSize::minimumHeight + 50 * round);
        window->createComponentSnapshot(window->getLocalBounds());
        waitFor(listener, 20);
        // The import is cancelled at once, so the current sound plays on.
        processor.view().workshop.openFile(mesh);
        waitFor(listener, 5);
        processor.view().workshop.cancelImport();
        restore(processor, round % 2 == 0 ? other : first);
        waitFor(listener, 20);
        processor.view().parameters.beginChange(ParameterId::level);
        processor.view().parameters.change(ParameterId::level, -0.5 * (round % 3));
        processor.view().parameters.endChange(ParameterId::level);
        waitFor(listener, 5);
        processor.windowSession().history.undo();
    }
    listener.finish();
    CHECK(listener.finite);
    CHECK(listener.loudest > 0.01f);
    // A 5 ms fade bends the waveform slightly more than the soft strikes do. A step of a tenth of
    // the peak would exceed the limit.
    CHECK(calm < 0.01f);
    CHECK(listener.sharpest / listener.loudest < 0.02f);
}

TEST_CASE("Every sample stays finite while a dropped mesh is analysed and played") {
    const auto mesh = testFolder() / "drop.obj";
    REQUIRE(writeMesh(sheetMesh(0.05, 0.035, 150), mesh));
    Processor processor;
    processor.prepareToPlay(testRateHz, blockSize);
    Listener listener(processor);
    const std::unique_ptr<juce::AudioProcessorEditor> window(processor.createEditor());
    const int before = processor.view().instrument.instrumentNumber();
    processor.view().workshop.openFile(mesh);
    waitUntil([&] { return !processor.view().workshop.importStatus().isWorking(); },
              [] { juce::Timer::callPendingTimersSynchronously(); });
    processor.poll(); // takes the last product
    CHECK(processor.view().workshop.importStatus().stage == ImportStatus::Stage::done);
    waitFor(listener, 200);
    listener.finish();
    CHECK(processor.view().instrument.instrumentNumber() > before);
    CHECK(processor.view().instrument.playedObjects().size() == 1);
    CHECK(listener.finite);
    CHECK(listener.loudest > 0.01f);
    CHECK(listener.loudest < 1.5f);
}
