// Tests of the mode spectrum and the quality meters, without a screen or processor.
#include "Editor/ModeSpectrum.h"
#include "Editor/BudgetRamp.h"
#include "Editor/Look.h"
#include "Editor/ModeText.h"
#include "Editor/SoundMeters.h"

#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <set>

using namespace idiophone;

namespace {

class RecordedView final : public SoundView {
public:
    const SoundFrame* takeSoundFrame() override { return nullptr; }
    void watchObject(std::optional<std::size_t>) override {}
    std::optional<std::size_t> watchedObject() const override { return {}; }
    bool muteMode(std::size_t, std::int32_t mode, bool isMuted) override {
        return change(muted, mode, isMuted);
    }
    bool hearModeAlone(std::size_t, std::int32_t mode, bool isAlone) override {
        return change(alone, mode, isAlone);
    }
    void unmuteModes(std::size_t) override { muted.clear(); }
    void hearAllModes(std::size_t) override { alone.clear(); }

    std::set<std::int32_t> muted, alone;
    bool refuses = false;

private:
    bool change(std::set<std::int32_t>& modes, std::int32_t mode, bool isIn) const {
        if (refuses)
            return false;
        if (isIn)
            modes.insert(mode);
        else
            modes.erase(mode);
        return true;
    }
};

SoundFrame frameOf(const std::vector<float>& frequenciesHz) {
    SoundFrame frame;
    frame.object = 0;
    frame.tauPascals = 1e-6;
    for (const float hz : frequenciesHz)
        frame.modes.push_back({.group = static_cast<std::int32_t>(frame.modes.size()),
                               .frequencyHz = hz,
                               .t60Seconds = 1,
                               .amplitude = 0.01f,
                               .standing = ModeStanding::sounding,
                               .isMuted = false,
                               .isHeardAlone = false});
    return frame;
}

juce::Image pictureOf(juce::Component& component) {
    return component.createComponentSnapshot(component.getLocalBounds(), true, 1);
}

/// Returns the number of pixels that nearly have the colour.
int pixelsOf(const juce::Image& picture, juce::Colour colour) {
    int count = 0;
    for (int y = 0; y < picture.getHeight(); ++y)
        for (int x = 0; x < picture.getWidth(); ++x) {
            const auto pixel = picture.getPixelAt(x, y);
            count += std::abs(pixel.getRed() - colour.getRed()) < 12 &&
                             std::abs(pixel.getGreen() - colour.getGreen()) < 12 &&
                             std::abs(pixel.getBlue() - colour.getBlue()) < 12
                         ? 1
                         : 0;
        }
    return count;
}

struct Shown {
    Shown() {
        spectrum.setLookAndFeel(&look);
        spectrum.setSize(340, 190);
    }
    ~Shown() { spectrum.setLookAndFeel(nullptr); }

    RecordedView view;
    Look look;
    ModeSpectrum spectrum{view};
};

} // namespace

TEST_CASE("Frequencies, times, levels and notes are shown with few digits") {
    CHECK(frequencyText(27.5) == "27.5 Hz");
    CHECK(frequencyText(440) == "440.0 Hz");
    CHECK(frequencyText(1447.03) == "1447 Hz");
    CHECK(frequencyText(9999.9) == "10.0 kHz");
    CHECK(frequencyText(12345) == "12.3 kHz");
    CHECK(secondsText(0.0851) == "85 ms");
    CHECK(secondsText(0.9996) == "1.00 s");
    CHECK(secondsText(2.314) == "2.31 s");
    CHECK(secondsText(123.4) == "123 s");
    CHECK(noteText(440) == "A4 +0 ct");
    CHECK(noteText(440 * std::exp2(0.14 / 12)) == "A4 +14 ct");
    CHECK(noteText(261.63 * std::exp2(-0.2 / 12)) == "C4 -20 ct");
    CHECK(noteText(30000) == "");
    CHECK(noteText(0) == "");
    CHECK(decibelsOf(1) == 0);
    CHECK(std::abs(decibelsOf(0.001) + 60) < 1e-9);
    CHECK(decibelsOf(0) == faintestDecibels);
}

TEST_CASE("A mode's description contains its figures, state and group") {
    auto frame = frameOf({440, 442, 1000});
    frame.modes[1].group = 0;
    CHECK(describeMode(frame, 0)[0] == "Mode 1: 440.0 Hz, A4 +0 ct, T60 1.00 s");
    CHECK(describeMode(frame, 0)[1] == "-40 dB, sounding, merged with 1 other");
    frame.modes[2] = {.group = 2,
                      .frequencyHz = 30000,
                      .t60Seconds = 0.05f,
                      .amplitude = 0,
                      .standing = ModeStanding::outOfBand,
                      .isMuted = true,
                      .isHeardAlone = false};
    CHECK(describeMode(frame, 2)[0] == "Mode 3: 30.0 kHz, T60 50 ms");
    CHECK(describeMode(frame, 2)[1] == "outside the audible band");
    frame.modes[2].standing = ModeStanding::silenced;
    CHECK(describeMode(frame, 2)[1] == "muted");
}

TEST_CASE("The scale is logarithmic between round frequencies and contains every mode") {
    const juce::Rectangle<float> levels(30, 5, 300, 100), decays(30, 110, 300, 40);
    const SpectrumScale scale(std::vector<double>{440, 7000}, levels, decays);
    CHECK(scale.lowestHz() == 200);
    CHECK(scale.highestHz() == 10000);
    CHECK(scale.x(200) == 30);
    CHECK(scale.x(10000) == 330);
    CHECK(std::abs(scale.x(std::sqrt(200.0 * 10000)) - 180) < 0.01f);
    CHECK(scale.levelY(0) == 5);
    CHECK(scale.levelY(-1000) == 105);
    CHECK(scale.decayY(1) < scale.decayY(0.1));
    CHECK(scale.decayY(1000) == 110);
    for (const double only : {0.1, 25.0, 440.0, 30000.0, 1e6}) {
        const SpectrumScale narrow(std::vector<double>{only}, levels, decays);
        CHECK(narrow.highestHz() >= 2 * narrow.lowestHz());
        CHECK(narrow.x(only) >= 30);
        CHECK(narrow.x(only) <= 330);
        CHECK_FALSE(narrow.frequencyTicks(26).empty());
    }
    const auto ticks = SpectrumScale({}, levels, decays).frequencyTicks(26);
    for (std::size_t k = 1; k < ticks.size(); ++k)
        CHECK(ticks[k].at - ticks[k - 1].at >= 26);
}

TEST_CASE("Sounding modes have the accent colour, muted modes a cross, and tau a line") {
    Shown shown;
    const auto accent = colourOf(shown.look.scheme(), LookColour::accent);
    const auto error = colourOf(shown.look.scheme(), LookColour::error);
    auto frame = frameOf({440, 1000, 3000});
    shown.spectrum.show(frame);
    const auto sounding = pictureOf(shown.spectrum);
    CHECK(pixelsOf(sounding, error) > 50);
    CHECK(pixelsOf(sounding, accent) > 60);
    for (auto& mode : frame.modes)
        mode.standing = ModeStanding::belowTau;
    shown.spectrum.show(frame);
    CHECK(pixelsOf(pictureOf(shown.spectrum), accent) < 5);
    const auto plain = pictureOf(shown.spectrum);
    frame.modes[1].isMuted = true;
    shown.spectrum.show(frame);
    const auto crossed = pictureOf(shown.spectrum);
    int changed = 0;
    for (int y = 0; y < plain.getHeight(); ++y)
        for (int x = 0; x < plain.getWidth(); ++x)
            changed += plain.getPixelAt(x, y) != crossed.getPixelAt(x, y) ? 1 : 0;
    CHECK(changed > 20); // of 7 x 7
    CHECK(changed < 80);
}

TEST_CASE("Merged modes are drawn with a common base") {
    Shown shown;
    auto frame = frameOf({440, 600, 3000});
    shown.spectrum.show(frame);
    const int apart =
        pixelsOf(pictureOf(shown.spectrum), colourOf(shown.look.scheme(), LookColour::accent));
    frame.modes[1].group = 0;
    shown.spectrum.show(frame);
    CHECK(pixelsOf(pictureOf(shown.spectrum), colourOf(shown.look.scheme(), LookColour::accent)) >
          apart + 30);
}

TEST_CASE("The mode under the mouse is found, and the arrows move from mode to mode") {
    Shown shown;
    auto& spectrum = shown.spectrum;
    CHECK_FALSE(spectrum.keyPressed(juce::KeyPress(juce::KeyPress::rightKey)));
    spectrum.show(frameOf({440, 1000, 3000}));
    const SpectrumScale scale(std::vector<double>{440, 1000, 3000}, {32, 6, 302, 100}, {});
    CHECK(spectrum.modeAt({scale.x(1000) + 4, 60}) == 1);
    CHECK(spectrum.modeAt({scale.x(3000) - 4, 20}) == 2);
    CHECK(spectrum.modeAt({(scale.x(1000) + scale.x(3000)) / 2, 60}) == std::nullopt);

    int told = 0;
    spectrum.onModeShown = [&] { ++told; };
    for (const std::size_t expected : {0, 1, 2, 2}) {
        CHECK(spectrum.keyPressed(juce::KeyPress(juce::KeyPress::rightKey)));
        CHECK(spectrum.modeShown() == expected);
    }
    CHECK(told == 4);
    CHECK(spectrum.keyPressed(juce::KeyPress(juce::KeyPress::leftKey)));
    CHECK(spectrum.modeShown() == 1);
    CHECK(spectrum.keyPressed(juce::KeyPress(juce::KeyPress::endKey)));
    CHECK(spectrum.modeShown() == 2);
    const auto handler = spectrum.createAccessibilityHandler();
    CHECK(handler->getValueInterface()->getCurrentValueAsString().startsWith("Mode 3: 3000 Hz"));
    CHECK(spectrum.keyPressed(juce::KeyPress(juce::KeyPress::escapeKey)));
    CHECK(spectrum.modeShown() == std::nullopt);
}

TEST_CASE("M toggles mute and S toggles solo; a refused change changes nothing") {
    Shown shown;
    auto& spectrum = shown.spectrum;
    spectrum.show(frameOf({440, 1000, 3000}));
    const juce::KeyPress m('m', {}, 'm'), s('s', {}, 's');
    CHECK_FALSE(spectrum.keyPressed(m)); // no mode is chosen
    spectrum.choose(1);
    CHECK(spectrum.keyPressed(m));
    CHECK(spectrum.keyPressed(s));
    CHECK(shown.view.muted == std::set<std::int32_t>{1});
    CHECK(shown.view.alone == std::set<std::int32_t>{1});
    CHECK(spectrum.frameShown().modes[1].isMuted);
    CHECK(spectrum.keyPressed(m));
    CHECK(spectrum.keyPressed(s));
    CHECK(shown.view.muted.empty());
    CHECK(shown.view.alone.empty());
    shown.view.refuses = true;
    CHECK(spectrum.keyPressed(m));
    CHECK_FALSE(spectrum.frameShown().modes[1].isMuted);
    spectrum.toggleMute(99);
    spectrum.choose(99);
    CHECK(spectrum.modeChosen() == 1);
}

TEST_CASE("Command shortcuts and the host's keys do not change the chosen mode") {
    Shown shown;
    shown.spectrum.show(frameOf({440, 1000, 3000}));
    shown.spectrum.choose(1);
    CHECK_FALSE(shown.spectrum.keyPressed({'s', juce::ModifierKeys::commandModifier, 's'}));
    CHECK(shown.view.alone.empty());
    CHECK_FALSE(shown.spectrum.keyStateChanged(true)); // the tests are no standalone program
}

TEST_CASE("A change of object clears the chosen mode") {
    Shown shown;
    shown.spectrum.show(frameOf({440, 1000, 3000}));
    shown.spectrum.choose(2);
    auto next = frameOf({440, 1000, 3000});
    shown.spectrum.show(next);
    CHECK(shown.spectrum.modeShown() == 2);
    next.object = 1;
    shown.spectrum.show(next);
    CHECK(shown.spectrum.modeShown() == std::nullopt);
}

TEST_CASE("The budget ramp describes the shares, and draws the line only where it is visible") {
    Look look;
    BudgetRamp ramp;
    ramp.setLookAndFeel(&look);
    ramp.setSize(300, 110);
    SoundFrame frame;
    frame.budgetModes = 64;
    ramp.show(frame);
    CHECK(ramp.description() == "Nothing sounds; the budget is 64 modes");
    for (const float entitlement : {40.0f, 24.0f})
        frame.slots.push_back({.object = 0,
                               .note = 60,
                               .amplitude = entitlement,
                               .modesRinging = 50,
                               .share = static_cast<std::int32_t>(entitlement),
                               .modesMixed = static_cast<std::int32_t>(entitlement),
                               .entitlement = entitlement});
    frame.modesMixed = 64;
    ramp.show(frame);
    CHECK(ramp.description() == "64 of 64 modes for 2 objects");
    // Between the bars only the line is drawn.
    const auto lineColour = colourOf(look.scheme(), LookColour::text);
    const auto betweenBars = [&] {
        return pixelsOf(pictureOf(ramp).getClippedImage({130, 24, 60, 60}), lineColour);
    };
    CHECK(betweenBars() > 20);
    for (auto& slot : frame.slots) {
        slot.share = slot.modesMixed = 50;
        slot.entitlement = 4000;
    }
    frame.budgetModes = 8000;
    frame.modesMixed = 100;
    ramp.show(frame);
    CHECK(ramp.description() == "100 of 8000 modes for 2 objects, as many as they request");
    CHECK(betweenBars() == 0);
    ramp.setLookAndFeel(nullptr);
}

TEST_CASE("Meters rise at once and fall slowly, and the load is shown in per cent") {
    SoundMeters meters;
    SoundFrame frame;
    CHECK(meters.description() == "Left silent, Right silent, CPU 0.0 %");
    frame.peakLeft = 0.5f;
    frame.load = 0.5f;
    meters.show(frame);
    CHECK(meters.description().startsWith("Left -6 dB, Right silent, CPU 7.5 %"));
    frame.peakLeft = 0;
    meters.show(frame);
    CHECK(meters.description().startsWith("Left -7 dB"));
    for (int k = 0; k < 100; ++k)
        meters.show(frame);
    CHECK(meters.description() == "Left silent, Right silent, CPU 50 %");
}
