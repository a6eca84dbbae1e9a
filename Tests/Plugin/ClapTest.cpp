#include "Plugin/ClapHost.h"

#include <catch2/catch_approx.hpp>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>

namespace idiophone {
namespace {

const std::string instrument = IDIOPHONE_CLAP_FILE;
const std::string resonator = IDIOPHONE_RESONATOR_CLAP_FILE;

double levelOf(const std::vector<float>& sound, std::size_t from = 0) {
    double power = 0;
    for (std::size_t k = from; k < sound.size(); ++k)
        power += double{sound[k]} * sound[k];
    return std::sqrt(power / static_cast<double>(sound.size() - from));
}

/// Returns the amplitude at a frequency (Goertzel), with a Hann window.
double amplitudeAt(const std::vector<float>& sound, double frequencyHz) {
    const double turn = 2 * std::numbers::pi / static_cast<double>(sound.size());
    const double step = 2 * std::cos(2 * std::numbers::pi * frequencyHz / 48000);
    double last = 0, secondLast = 0;
    for (std::size_t k = 0; k < sound.size(); ++k) {
        const double window = 1 - std::cos(turn * static_cast<double>(k));
        const double next = step * last - secondLast + window * double{sound[k]};
        secondLast = last;
        last = next;
    }
    return std::sqrt(last * last + secondLast * secondLast - step * last * secondLast);
}

double loudestHz(const std::vector<float>& sound) {
    double loudest = 0, amplitude = 0;
    for (double frequencyHz = 200; frequencyHz < 4000; ++frequencyHz)
        if (const double each = amplitudeAt(sound, frequencyHz); each > amplitude) {
            amplitude = each;
            loudest = frequencyHz;
        }
    return loudest;
}

std::vector<float> played(const std::vector<ClapEvent>& events, std::size_t blocks = 50) {
    return ClapInstance(instrument).render(events, blocks);
}

/// Returns the loudest frequency of a key without bends, and remembers it.
double straightHz(int key) {
    static std::map<int, double> known;
    const auto [of, isNew] = known.try_emplace(key);
    if (isNew)
        of->second = loudestHz(played({noteOn(0, key, 1)}));
    return of->second;
}

/// Checks that of keys 72 and 79 the upper one is bent by 1.5 semitones.
void checkBendsHigh(const std::vector<float>& sound) {
    const auto straight = played({noteOn(0, 72, 1), noteOn(0, 79, 2)});
    const auto low = straightHz(72), high = straightHz(79);
    CHECK(amplitudeAt(sound, low) == Catch::Approx(amplitudeAt(straight, low)).epsilon(0.1));
    CHECK(amplitudeAt(sound, high) < 0.1 * amplitudeAt(straight, high));
    CHECK(amplitudeAt(sound, high * std::exp2(1.5 / 12)) > 0.5 * amplitudeAt(straight, high));
}

} // namespace

TEST_CASE("The CLAP file names its plugin and features") {
    const ClapInstance plugin(instrument), effect(resonator);
    CHECK(plugin.descriptor().name == std::string("Idiophone"));
    CHECK(plugin.descriptor().id == std::string("org.idiophone.idiophone"));
    CHECK(plugin.descriptor().features[0] == std::string(CLAP_PLUGIN_FEATURE_INSTRUMENT));
    CHECK(effect.descriptor().name == std::string("Idiophone Resonator"));
    CHECK(effect.descriptor().features[0] == std::string(CLAP_PLUGIN_FEATURE_AUDIO_EFFECT));
}

TEST_CASE("A CLAP plays a note at its sample") {
    const auto sound = played({noteOn(1000, 72, 1)});
    CHECK(levelOf({sound.begin(), sound.begin() + 1000}) == 0);
    CHECK(levelOf({sound.begin() + 1000, sound.begin() + 5800}) > 0.001);
}

TEST_CASE("A CLAP note of velocity 0 sounds") {
    CHECK(levelOf(played({noteOn(0, 72, 1, 0)})) > 1e-6);
}

TEST_CASE("A CLAP host restores a saved state") {
    const ClapInstance first(instrument), second(instrument);
    const auto size = first.parameter("Size");
    const double moved = first.value(size) > 0.5 ? 0.25 : 0.75;
    first.render({parameterEvent(size, moved)}, 1);
    CHECK(second.value(size) != Catch::Approx(moved));
    second.restore(first.save());
    CHECK(second.value(size) == Catch::Approx(moved));
    CHECK(levelOf(second.render({noteOn(0, 72, 1)}, 50)) > 0.001);
}

TEST_CASE("A CLAP tuning expression bends its note alone") {
    checkBendsHigh(played(
        {noteOn(0, 72, 1), noteOn(0, 79, 2), expression(0, CLAP_NOTE_EXPRESSION_TUNING, 2, 1.5)}));
}

TEST_CASE("A CLAP note does not keep the tuning of the note before it") {
    std::vector<ClapEvent> events;
    for (int id = 0; id < 16; ++id) { // one more than there are channels
        events.push_back(noteOn(0, 40 + id, id, 0.01));
        events.push_back(expression(0, CLAP_NOTE_EXPRESSION_TUNING, id, 7));
        events.push_back(noteEvent(CLAP_EVENT_NOTE_CHOKE, 0, 40 + id, id, 0));
    }
    const ClapInstance plugin(instrument);
    plugin.render(events, 100);
    const auto sound = plugin.render({noteOn(0, 72, 99)}, 50);
    CHECK(loudestHz(sound) == Catch::Approx(straightHz(72)).margin(2));
}

TEST_CASE("A CLAP tuning expression is ignored while MPE is off") {
    const std::vector<ClapEvent> straight{noteOn(0, 72, 1)},
        bent{noteOn(0, 72, 1), expression(0, CLAP_NOTE_EXPRESSION_TUNING, 1, 2)};
    const auto playedWithoutMpe = [](const std::vector<ClapEvent>& events) {
        const ClapInstance plugin(instrument);
        const auto mpe = plugin.parameter("MPE");
        CHECK(plugin.value(mpe) == 1);
        plugin.render({parameterEvent(mpe, 0)}, 1);
        return plugin.render(events, 50);
    };
    CHECK(playedWithoutMpe(bent) == playedWithoutMpe(straight));
}

TEST_CASE("A CLAP pressure expression damps its note") {
    const auto rings = played({noteOn(0, 72, 1)});
    const auto damped =
        played({noteOn(0, 72, 1), expression(4800, CLAP_NOTE_EXPRESSION_PRESSURE, 1, 1)});
    CHECK(levelOf(damped, 12000) < 0.7 * levelOf(rings, 12000));
}

TEST_CASE("A CLAP choke releases a note faster than a note-off") {
    const auto after = [](std::uint16_t type) {
        const ClapInstance plugin(instrument);
        plugin.render({parameterEvent(plugin.parameter("Let ring"), 0)}, 1);
        return levelOf(plugin.render({noteOn(0, 72, 1), noteEvent(type, 4800, 72, 1, 0)}, 50),
                       9600);
    };
    CHECK(after(CLAP_EVENT_NOTE_CHOKE) < after(CLAP_EVENT_NOTE_OFF));
}

TEST_CASE("A CLAP says which parameters a host may modulate, and how many voices it has") {
    const ClapInstance plugin(instrument);
    const auto modulates = [&](const char* name, std::uint32_t how) {
        return (plugin.parameter(name).flags & how) == how;
    };
    const std::uint32_t all = CLAP_PARAM_IS_MODULATABLE,
                        perNote = all | CLAP_PARAM_IS_MODULATABLE_PER_NOTE_ID;
    CHECK(modulates("Volume", all));
    CHECK_FALSE(modulates("Volume", perNote));
    CHECK_FALSE(modulates("Material", all));
    CHECK_FALSE(modulates("MPE", all));
    CHECK(modulates("Tune", perNote));
    CHECK(modulates("Mallet hardness", perNote));
    CHECK(plugin.voices().voice_count == 128);
}

TEST_CASE("A CLAP host modulates a parameter of all notes and leaves its value") {
    const ClapInstance plugin(instrument);
    const auto volume = plugin.parameter("Volume");
    const auto state = plugin.save();
    const auto softer =
        plugin.render({modulationEvent(0, volume, -10.0 / 72), noteOn(0, 72, 1)}, 50);
    CHECK(levelOf(softer, 9600) ==
          Catch::Approx(levelOf(played({noteOn(0, 72, 1)}), 9600) * std::pow(10, -0.5))
              .epsilon(0.01));
    CHECK(plugin.value(volume) == Catch::Approx(60.0 / 72));
    CHECK(plugin.save() == state);
}

TEST_CASE("Parameters that a CLAP host may not modulate stay") {
    const ClapInstance plugin(instrument);
    const auto sound =
        plugin.render({modulationEvent(0, plugin.parameter("Material"), 0.5),
                       modulationEvent(0, plugin.parameter("Bypass"), 1), noteOn(0, 72, 1)},
                      50);
    CHECK(sound == played({noteOn(0, 72, 1)}));
}

TEST_CASE("A CLAP host modulates one note alone, by its number, its key or its channel") {
    const ClapInstance plugin(instrument);
    auto event = modulationEvent(0, plugin.parameter("Tune"), 0.0625, 2); // of 2400 cents
    SECTION("by its number, without a cookie") {
        event.modulation.cookie = nullptr;
    }
    SECTION("by its key") {
        event.modulation.note_id = -1;
        event.modulation.key = 79;
    }
    SECTION("by its channel") {
        event.modulation.note_id = -1;
        event.modulation.channel = 1;
    }
    auto high = noteOn(0, 79, 2);
    high.note.channel = 1;
    checkBendsHigh(plugin.render({noteOn(0, 72, 1), high, event}, 50));
    // A new note of the key has none of it.
    const auto next = plugin.render({noteOn(0, 79, 3)}, 50);
    CHECK(loudestHz(next) == Catch::Approx(straightHz(79)).margin(2));
}

TEST_CASE("A CLAP note with an amount of its own ignores the amount of all notes") {
    const ClapInstance plugin(instrument);
    const auto tune = plugin.parameter("Tune");
    const auto straight = straightHz(72);
    const auto moved = plugin.render(
        {modulationEvent(0, tune, 0.125), noteOn(0, 72, 1), modulationEvent(0, tune, 0.0625, 1)},
        50);
    CHECK(loudestHz(moved) == Catch::Approx(straight * std::exp2(1.5 / 12)).margin(2));
    // It does not even wobble while that amount moves.
    const ClapInstance steady(instrument), moving(instrument);
    std::vector<ClapEvent> events{noteOn(0, 72, 1), modulationEvent(0, tune, 0.1, 1)};
    const auto expected = steady.render(events, 50);
    events.push_back(modulationEvent(9600, tune, 0.2));
    const auto sound = moving.render(events, 50);
    for (std::size_t k = 0; k < sound.size(); ++k)
        REQUIRE(sound[k] == Catch::Approx(expected[k]).margin(1e-5));
}

TEST_CASE("A CLAP note strikes as the host modulates it") {
    const auto softened = [](int id) {
        const ClapInstance plugin(instrument);
        const auto hardness = plugin.parameter("Hardness");
        return plugin.render({noteOn(0, 72, 1), modulationEvent(0, hardness, -0.5, id)}, 50);
    };
    const auto brightness = [](std::vector<float> sound) {
        const double level = levelOf(sound);
        std::adjacent_difference(sound.begin(), sound.end(), sound.begin());
        return levelOf(sound) / level;
    };
    CHECK(brightness(softened(1)) < 0.8 * brightness(softened(2)));
}

TEST_CASE("A CLAP host modulates the release time of one note") {
    const auto after = [](double amount) {
        const ClapInstance plugin(instrument);
        plugin.render({parameterEvent(plugin.parameter("Let ring"), 0),
                       parameterEvent(plugin.parameter("Room"), 0)},
                      1);
        const auto release = plugin.parameter("Release time");
        return levelOf(plugin.render({noteOn(0, 72, 1), modulationEvent(960, release, amount, 1),
                                      noteEvent(CLAP_EVENT_NOTE_OFF, 4800, 72, 1, 0)},
                                     50),
                       9600);
    };
    CHECK(after(-0.2) < 0.1 * after(0));
}

TEST_CASE("A CLAP note ends when its key is up and its object silent, or struck again") {
    const ClapInstance plugin(instrument);
    plugin.render({parameterEvent(plugin.parameter("Let ring"), 0)}, 1);
    plugin.render({noteOn(0, 72, 1), noteOn(0, 74, 2)}, 20);
    CHECK(plugin.noteEnds().empty());
    plugin.render({noteEvent(CLAP_EVENT_NOTE_OFF, 100, 72, 1, 0)}, 500);
    REQUIRE(plugin.noteEnds().size() == 1);
    const auto first = plugin.noteEnds()[0];
    CHECK(first.note_id == 1);
    CHECK(first.key == 72);
    CHECK(first.header.time > 480);
    plugin.render({noteEvent(CLAP_EVENT_NOTE_OFF, 0, 74, 2, 0), noteOn(300, 74, 3)}, 1);
    REQUIRE(plugin.noteEnds().size() == 1);
    CHECK(plugin.noteEnds()[0].note_id == 2);
    CHECK(plugin.noteEnds()[0].header.time == 300);
}

TEST_CASE("A short CLAP note at the end of a block does not end before it is heard") {
    const ClapInstance plugin(instrument);
    plugin.render({noteOn(470, 72, 1), noteEvent(CLAP_EVENT_NOTE_OFF, 475, 72, 1, 0)}, 1);
    CHECK(plugin.noteEnds().empty());
    CHECK(levelOf(plugin.render({}, 10)) > 0.001);
    CHECK(plugin.noteEnds().empty());
}

TEST_CASE("A CLAP note that plays nothing ends with its key") {
    const ClapInstance plugin(instrument);
    plugin.render({noteOn(0, 0, 1), noteEvent(CLAP_EVENT_NOTE_OFF, 100, 0, 1, 0)}, 1);
    REQUIRE(plugin.noteEnds().size() == 1);
    CHECK(plugin.noteEnds()[0].header.time == ClapInstance::blockSamples - 1);
}

TEST_CASE("A CLAP that is activated anew has no notes") {
    const ClapInstance plugin(instrument);
    plugin.render({noteOn(0, 72, 1)}, 1);
    plugin.activateAnew();
    plugin.render({noteEvent(CLAP_EVENT_NOTE_OFF, 0, 72, 1, 0)}, 1);
    CHECK(plugin.noteEnds().empty());
}

TEST_CASE("A CLAP resonator rings after its input") {
    const ClapInstance effect(resonator);
    std::vector<float> click(480, 0.0f);
    click[0] = 1;
    CHECK(levelOf(effect.render({}, 50, click), 9600) > 1e-7);
}

} // namespace idiophone
