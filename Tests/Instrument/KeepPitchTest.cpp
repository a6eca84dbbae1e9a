// Tests that keys keep their pitch in any material, size and thickness.
#include "Instrument/Instrument.h"
#include "Instrument/ObjectLibrary.h"
#include "Instrument/Player.h"
#include "Instrument/SettingsOfParameters.h"
#include "Support/KeyedPresets.h"
#include "Support/PoleFit.h"
#include "Support/RenderNotes.h"
#include "Synth/SynthesiserSlot.h"

#include <algorithm>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <numbers>
#include <string>

using namespace idiophone;
using namespace idiophone::test;

namespace {

using enum ParameterId;

constexpr double sampleRateHz = 48000;

double noteHz(double note) {
    return 440 * std::exp2((note - 69) / 12.0);
}

/// The mode of a key's fundamental, or of the partial an octave above its pitch.
struct Fundamental {
    std::size_t mode = 0;
    double ratio = 1;        ///< of the mode's frequency to the pitch
    std::size_t partner = 0; ///< the other mode that the tube shares, or the mode itself
};

/// Returns the mean over a mode and its partner, weighted by power, as they are heard.
template <class ValueOf>
double weightedMean(const ModalObject& object, const Fundamental& shared, const ValueOf& valueOf) {
    if (shared.partner == shared.mode)
        return valueOf(shared.mode);
    const double one = static_cast<double>(std::norm(object.gains[shared.mode]));
    const double other = static_cast<double>(std::norm(object.gains[shared.partner]));
    return (one * valueOf(shared.mode) + other * valueOf(shared.partner)) / (one + other);
}

Fundamental fundamentalOf(const Preset& preset, const ModalObject& object, int note) {
    const double reference = preset.keyMap.referenceNote;
    const bool isScaled = preset.keyMap.kind == KeyMapKind::scaled;
    if (isScaled && reference < 0)
        return {.partner = sharingPartner(object, 0).value_or(0)};
    Fundamental found{.ratio = preset.name == "Tubular Bells" ? 2.0 : 1.0};
    const double pitchHz = found.ratio * noteHz(isScaled ? reference : note);
    const auto miss = [&](std::size_t mode) {
        return std::abs(cents(object.dampedFrequencyHz(mode), pitchHz));
    };
    for (std::size_t mode = 0; mode < object.modeCount(); ++mode)
        if (miss(mode) < miss(found.mode))
            found.mode = mode;
    if (isScaled && miss(found.mode) > 50) // no mode has the reference's pitch
        found.mode = 0;
    found.partner = sharingPartner(object, found.mode).value_or(found.mode);
    if (isScaled)
        found.ratio = std::exp2(weightedMean(object, found, [&](std::size_t mode) {
            return std::log2(object.dampedFrequencyHz(mode) / pitchHz);
        }));
    return found;
}

std::shared_ptr<const Instrument> instrumentOf(const Preset& preset) {
    return Instrument::build(preset.keyMap, ObjectLibrary::shared()).value();
}

/// Returns the preset's values in its own, the custom and every library material.
std::vector<ParameterValues> inAllMaterials(const Preset& preset) {
    std::vector<ParameterValues> all{preset.parameters};
    auto custom = preset.parameters;
    custom.set(material, customMaterial);
    custom.set(youngsModulus, 1.7);
    custom.set(density, 400);
    custom.set(fluidDamping, 90);
    custom.set(viscoelasticDamping, 0.4);
    custom.set(lossFactor, 0.02);
    all.push_back(custom);
    for (std::size_t k = 0; k < materialLibrary().size(); ++k) {
        auto values = preset.parameters;
        values.set(material, static_cast<double>(firstLibraryMaterial + k));
        all.push_back(values);
    }
    return all;
}

double missCents(const Instrument& instrument,
                 const ParameterValues& values,
                 int note,
                 const Fundamental& fundamental) {
    const auto& slot = instrument.slots()[static_cast<std::size_t>(instrument.key(note).slot)];
    const auto settings = synthesisSettings(values);
    const auto missOf = [&](std::size_t mode) {
        const auto pole = liveConditions(slot, settings)
                              .law.pole(slot.object->eigenvalueAt(mode, settings.thicknessRatio),
                                        slot.object->damping(mode));
        return cents(dampedFrequency(pole) / (2 * std::numbers::pi),
                     fundamental.ratio * noteHz(note));
    };
    return weightedMean(*slot.object, fundamental, missOf);
}

/// Renders one stream in blocks of a size; the next values act every 960 samples.
StereoSound renderAutomated(const std::shared_ptr<const Instrument>& instrument,
                            const std::vector<ParameterValues>& values,
                            std::size_t blockSize) {
    constexpr std::size_t segment = 960;
    Player player(instrument, sampleRateHz);
    StereoSound sound(segment * values.size());
    for (std::size_t start = 0; start < sound.left.size();) {
        const auto index = start / segment;
        const auto count = std::min(blockSize, (index + 1) * segment - start);
        std::vector<MidiEvent> events;
        if (start == 0)
            events = {midi(0, 0x90, 67, 100), midi(0, 0x90, 40, 100)};
        player.process(StereoSpan(sound).subspan(start, count), events, values[index]);
        start += count;
    }
    return sound;
}

} // namespace

TEST_CASE("Every key of every keyboard keeps its pitch within 1 cent in any material, size and "
          "thickness") {
    int keyboards = 0;
    for (const auto& preset : keyedFactoryPresets()) {
        if (preset.keyMap.kind == KeyMapKind::zones || preset.keyMap.kind == KeyMapKind::kit)
            continue;
        ++keyboards;
        const auto instrument = instrumentOf(preset);
        auto all = inAllMaterials(preset);
        for (std::size_t k = 0; k < all.size(); ++k) { // another size with each material
            CHECK(all[k][keepPitch] == 1);
            all[k].set(size, std::array{1.0, 0.1, 3.0, 10.0}[k % 4]);
            all[k].set(thickness, std::array{100.0, 400.0, 25.0}[k % 3]);
        }
        double worst = 0;
        for (int note = preset.keyMap.lowestNote; note <= preset.keyMap.highestNote; ++note) {
            const auto slot = static_cast<std::size_t>(instrument->key(note).slot);
            const auto fundamental = fundamentalOf(preset, *instrument->slots()[slot].object, note);
            for (const auto& values : all)
                worst =
                    std::max(worst, std::abs(missCents(*instrument, values, note, fundamental)));
        }
        INFO(preset.name << ": " << worst << " cents");
        CHECK(worst < 1);
    }
    CHECK(keyboards >= 14);
}

TEST_CASE("Rendered notes in another material have the pitch of their key") {
    struct Case {
        const char* preset;
        const char* material;
        int note;
        double size;
    };
    for (const auto& [name, materialName, note, extent] :
         {Case{"Vibraphone", "Glass", 67, 1}, Case{"Vibraphone", "Polycarbonate", 67, 1},
          Case{"Marimba", "Mild steel", 60, 0.5}, Case{"Glockenspiel", "Rosewood", 79, 2},
          Case{"Rosewood Xylophone", "Aluminium", 48, 1}, Case{"Handbell", "Mild steel", 72, 1.5},
          Case{"Glass Bowls", "Aluminium", 43, 1}}) {
        INFO(name << ", note " << note << ", in " << materialName);
        const auto* preset = findFactoryPreset(name);
        const auto* chosen = findMaterial(materialName);
        REQUIRE((preset != nullptr && chosen != nullptr));
        auto values = preset->parameters;
        values.set(material,
                   static_cast<double>(firstLibraryMaterial + (chosen - materialLibrary().data())));
        values.set(size, extent);
        values.set(compression, 0);
        values.set(radiation, 0);
        Player player(instrumentOf(*preset), sampleRateHz);
        const auto sound = render(player, {midi(0, 0x90, note, 100)}, 14400, 480, values);
        const auto pole = fitPole(sound, sampleRateHz, noteHz(note), 0.06);
        CHECK(std::abs(cents(pole.frequencyHz, noteHz(note))) < 1);
        values.set(keepPitch, 0);
        Player off(instrumentOf(*preset), sampleRateHz);
        const auto moved = render(off, {midi(0, 0x90, note, 100)}, 14400, 480, values);
        const auto& slot =
            off.instrument().slots()[static_cast<std::size_t>(off.instrument().key(note).slot)];
        const double ratio = std::sqrt(chosen->youngsModulusPa / chosen->densityKgPerM3 /
                                       (slot.object->material.youngsModulusPa /
                                        slot.object->material.densityKgPerM3)) /
                             extent;
        const auto movedPole = fitPole(moved, sampleRateHz, ratio * noteHz(note), 0.06);
        CHECK(std::abs(cents(movedPole.frequencyHz, ratio * noteHz(note))) < 30);
    }
}

TEST_CASE("Tunings and bends act on a kept pitch to a hundredth of a cent") {
    const auto* marimba = findFactoryPreset("Marimba");
    REQUIRE(marimba != nullptr);
    const auto instrument = instrumentOf(*marimba);
    auto values = marimba->parameters;
    values.set(material, customMaterial);
    values.set(concertPitch, 432);
    values.set(tune, 250);
    for (const int note : {30, 60, 100}) {
        const auto& slot =
            instrument->slots()[static_cast<std::size_t>(instrument->key(note).slot)];
        REQUIRE(slot.pitch);
        const auto live = liveConditions(slot, synthesisSettings(values), 1.25);
        const auto pole = live.law.pole(slot.pitch->eigenvalue, slot.pitch->damping);
        const double expectedHz = slot.pitch->hz * 432 / 440 * std::exp2(2.5 / 12) * 1.25;
        CHECK(std::abs(cents(dampedFrequency(pole) / (2 * std::numbers::pi), expectedHz)) < 0.01);
    }
}

TEST_CASE("Objects without pitched keys follow the material with the switch on or off") {
    for (const char* name : {"Steel Plate", "Wok"}) {
        const auto* preset = findFactoryPreset(name);
        REQUIRE(preset != nullptr);
        const auto instrument = instrumentOf(*preset);
        CHECK_FALSE(hasPitch(instrument->slots()));
        auto values = preset->parameters;
        values.set(size, 2);
        const auto on = liveConditions(instrument->slots()[0], synthesisSettings(values));
        values.set(keepPitch, 0);
        CHECK(liveConditions(instrument->slots()[0], synthesisSettings(values)).law == on.law);
        CHECK(std::abs(on.frequencyRatio() - 0.5) < 1e-12);
    }
}

TEST_CASE("Automation of material, size and keep pitch is the same for all block sizes") {
    const auto* preset = findFactoryPreset("Vibraphone");
    REQUIRE(preset != nullptr);
    const auto instrument = instrumentOf(*preset);
    std::vector<ParameterValues> values;
    for (int segment = 0; segment < 24; ++segment) {
        auto now = preset->parameters;
        now.set(material, segment % 8);
        now.set(size, std::exp2((segment % 5 - 2) / 2.0));
        now.set(youngsModulus, 5.0 * (segment + 1));
        now.set(keepPitch, segment % 6 == 5 ? 0 : 1);
        values.push_back(now);
    }
    const auto expected = renderAutomated(instrument, values, 480);
    CHECK(std::ranges::any_of(expected.left, [](float sample) { return sample != 0; }));
    for (const std::size_t blockSize : {1, 64, 100, 960})
        CHECK(renderAutomated(instrument, values, blockSize) == expected);
}

TEST_CASE("Ringing sound stays continuous when its material changes and its pitch is kept") {
    const auto* preset = findFactoryPreset("Vibraphone");
    REQUIRE(preset != nullptr);
    const auto instrument = instrumentOf(*preset);
    auto before = preset->parameters;
    before.set(radiation, 0);
    before.set(motorDepth, 0);
    auto after = before;
    after.set(material, firstLibraryMaterial);
    const auto stepAt = [&](const ParameterValues& then) {
        Player player(instrument, sampleRateHz);
        StereoSound sound(9600);
        const std::array note{midi(0, 0x90, 60, 100)};
        player.process(StereoSpan(sound).subspan(0, 4800), note, before);
        player.process(StereoSpan(sound).subspan(4800, 4800), {}, then);
        float step = 0; // largest second difference around the grid point
        for (std::size_t i = 4700; i < 4900; ++i)
            step =
                std::max(step, std::abs(sound.left[i + 1] - 2 * sound.left[i] + sound.left[i - 1]));
        return step;
    };
    CHECK(stepAt(after) < 1.5f * stepAt(before));
}
