#include "Plugin/TestSound.h"
#include "Instrument/FactoryContent.h"
#include "Instrument/LoudnessMatch.h"
#include "Plugin/ObjectEmbedding.h"
#include <catch2/catch_test_macros.hpp>
#include <chrono>
#include <iostream>
#include <thread>
using namespace idiophone;
using namespace idiophone::test;
TEST_CASE("measurelufs", "[.measure]") {
    for (const auto& preset : factoryPresets()) {
        auto built = buildInstrument(preset.keyMap, std::vector<EmbeddedObject>{});
        const LoudnessMatch match(*built, preset.surface, 48000, preset.parameters);
        std::cout << preset.name << " " << match.predictedLufs(preset.parameters)[1] + preset.parameters[ParameterId::level] << "\n";
    }
}
TEST_CASE("measureimport", "[.measure]") {
    for (std::string f : {"ball.obj","plate.obj","hoop.obj","Prusa.stl","teapot.obj","frog_legs.obj","bar.obj","ring.obj"}) {
        Processor processor;
        processor.prepareToPlay(48000, 512);
        const auto t0 = std::chrono::steady_clock::now();
        const auto now = [&] { return std::chrono::duration<double>(std::chrono::steady_clock::now() - t0).count(); };
        processor.openFile("/tmp/boot/s7/wa/m/" + f);
        int loads = processor.instrumentNumber();
        std::cout << "== " << f << "\n";
        const auto blow = [&](int note) {
            juce::MidiBuffer midi;
            midi.addEvent(juce::MidiMessage::noteOn(1, note, juce::uint8(100)), 10);
            const auto s = render(processor, 24000, 512, midi);
            processor.reset();
            return loudest(s);
        };
        while (processor.importStatus().isWorking() && now() < 90) {
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
            const auto a = now();
            juce::Timer::callPendingTimersSynchronously();
            const auto b = now();
            if (processor.instrumentNumber() != loads) {
                loads = processor.instrumentNumber();
                const auto st = processor.importStatus();
                std::cout << b << " s: stage " << int(st.stage) << " " << st.summary << " install " << b - a << " s, level "
                          << processor.parameterValue(ParameterId::level) << " peaks " << blow(36) << " " << blow(60) << " " << blow(84) << " " << blow(96)
                          << " state " << saved(processor).size() << std::endl;
                const auto c = now();
                processor.setKeyLayout(KeyLayout::zones);
                std::cout << "   zones in " << now() - c << " level " << processor.parameterValue(ParameterId::level) << " peaks " << blow(36) << " " << blow(60) << " " << blow(84) << std::endl;
                processor.setKeyLayout(KeyLayout::scaled);
                loads = processor.instrumentNumber();
            }
        }
        juce::Timer::callPendingTimersSynchronously();
        const auto st = processor.importStatus();
        std::cout << now() << " end stage " << int(st.stage) << " " << st.error << " | " << st.notes << std::endl;
    }
}
