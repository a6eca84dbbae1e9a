#include "Plugin/ImportedSound.h"

#include "Instrument/PhrasePrediction.h"
#include "Instrument/StartingLevel.h"
#include "Plugin/SessionParts.h"
#include "Support/TestSound.h"

#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>

using namespace idiophone;
using namespace idiophone::test;
using enum ParameterId;

namespace {

/// Returns the first product of a new file.
ObjectWorkshop::Product bowl(float gain = 0.2f) {
    auto object = syntheticObject({440, 1180, 2210}, {gain, gain, gain});
    object.name = "Bowl";
    return {.object = std::make_shared<const ModalObject>(std::move(object)),
            .objectName = "imported/Bowl-1",
            .isPreview = false,
            .isFirst = true,
            .isNewFile = true};
}

} // namespace

TEST_CASE("The first product of a file plays at the pitches of the keys, of its own material") {
    auto before = testSound();
    before.preset.mutedModes.set("test", 3, true);
    before.presetId = "Bells/Bell.json";
    before.parameters.set(material, customMaterial);
    before.parameters.set(thickness, 150);
    const auto product = bowl();
    const auto sound = soundOf(product, before, testRateHz);
    REQUIRE(sound);
    CHECK(plays(sound->instrument, *product.object));
    CHECK(layoutOf(sound->instrument) == KeyLayout::scaled);
    CHECK(sound->preset.keyMap.object == "imported/Bowl-1");
    CHECK(sound->preset.name == "Bowl");
    CHECK_THAT(sound->preset.description,
               Catch::Matchers::StartsWith("Bowl: 3 modes from 440.0 Hz"));
    CHECK(sound->preset.tags == std::vector<std::string>{"imported"});
    CHECK(sound->preset.mutedModes == ModeSet());
    CHECK(sound->presetId.empty());
    CHECK(sound->parameters[material] == double{ownMaterial});
    CHECK(sound->parameters[thickness] == parameterInfo(thickness).defaultValue);
    CHECK(sound->parameters[level] ==
          startingLevel({sound->instrument, sound->preset.surface, testRateHz}, sound->parameters));
}

TEST_CASE("A later product keeps the keys and the material that the user has chosen meanwhile") {
    auto product = bowl();
    auto before = soundOf(product, testSound(), testRateHz).value();
    before.preset.keyMap.kind = KeyMapKind::zones;
    before.preset.keyMap.lowestNote = 48;
    before.parameters.set(material, customMaterial);
    product.isFirst = false;
    product.isPreview = true;
    product.objectName = "imported/Bowl-2";
    const auto sound = soundOf(product, before, testRateHz);
    REQUIRE(sound);
    CHECK(layoutOf(sound->instrument) == KeyLayout::zones);
    CHECK(sound->preset.keyMap.lowestNote == 48);
    CHECK(sound->preset.keyMap.object == "imported/Bowl-2");
    CHECK(sound->parameters[material] == double{customMaterial});
    CHECK_THAT(sound->preset.description, Catch::Matchers::ContainsSubstring("A preview"));
}

TEST_CASE("A louder object gets a lower level, by as much as it is predicted to be louder") {
    auto before = soundOf(bowl(), testSound(), testRateHz).value();
    auto loud = soundOf(bowl(0.4f), testSound(), testRateHz).value();
    before.parameters.set(level, parameterInfo(level).maximum); // beyond its headroom
    loud.parameters = before.parameters;
    const auto lufs = [&](const Sound& sound) {
        return predictedLufs({sound.instrument, sound.preset.surface, testRateHz},
                             sound.parameters);
    };
    const auto matched = asLoudAs(before, loud, testRateHz);
    const double lower = before.parameters[level] - matched.parameters[level];
    CHECK(lower > 3);
    CHECK(std::abs(lower - (lufs(loud) - lufs(before))) < 1e-9);
}

TEST_CASE("A sound within its headroom leaves the next one headroom") {
    const auto quiet = soundOf(bowl(), testSound(), testRateHz).value();
    const auto loud = soundOf(bowl(0.4f), testSound(), testRateHz).value();
    const auto matched = asLoudAs(loud, quiet, testRateHz);
    CHECK(matched.parameters[level] > loud.parameters[level]);
    CHECK(matched.parameters[level] <=
          highestLevel({quiet.instrument, quiet.preset.surface, testRateHz}, quiet.parameters));
}

TEST_CASE("Without a former instrument the level stays") {
    const auto sound = soundOf(bowl(), testSound(), testRateHz).value();
    const Sound nothing;
    CHECK(asLoudAs(nothing, sound, testRateHz) == sound);
}

TEST_CASE("A keyboard of bars has no key layout, and nothing plays without an instrument") {
    const auto object = bowl().object;
    CHECK_FALSE(layoutOf(testSound().instrument));
    CHECK_FALSE(layoutOf(nullptr));
    CHECK_FALSE(plays(testSound().instrument, *object));
    CHECK_FALSE(plays(nullptr, *object));
}
