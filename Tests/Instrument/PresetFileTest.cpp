#include "Instrument/PresetFile.h"
#include "Instrument/ObjectLibrary.h"

#include "Instrument/FactoryContent.h"
#include "Instrument/PhrasePrediction.h"
#include "Object/FileBytes.h"
#include "Support/TestFolder.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <fstream>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Matchers::ContainsSubstring;

namespace {

std::filesystem::path write(const std::filesystem::path& name, const std::string& text) {
    const auto file = testFolder() / name;
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << text;
    return file;
}

} // namespace

TEST_CASE("A preset file is read whole, and the error for a bad file names it") {
    const auto& preset = factoryPresets()[2];
    CHECK(readPresetFile(write("a/preset.json", encodePreset(preset))).value() == preset);
    for (const auto& file : {write("a/broken.json", "{"), testFolder() / "a/missing.json",
                             write("a/large.json", std::string((1 << 20) + 1, ' '))}) {
        const auto read = readPresetFile(file);
        REQUIRE_FALSE(read);
        CHECK_THAT(read.error().message, ContainsSubstring(file.filename().string()));
    }
}

TEST_CASE(
    "A preset's objects are found in its own folder and the folders above, the nearest first") {
    const auto top = write("b/Objects/bowl.modal", "top");
    const auto near = write("b/Bells/Objects/bowl.modal", "near");
    write("b/Objects/stones/60.modal", "stone");
    const KeyMap bowl{.kind = KeyMapKind::scaled, .object = "Objects/bowl.modal"};
    const auto found = [&](const KeyMap& map, const char* preset) {
        return withObjectsBeside(map, testFolder() / preset).object;
    };
    CHECK(found(bowl, "b/x.json") == storedNameOf(top));
    CHECK(found(bowl, "b/Bells/x.json") == storedNameOf(near));
    CHECK(found(bowl, "b/Gongs/Large/x.json") == storedNameOf(top));
    CHECK(found(bowl, "c/x.json") == bowl.object);
    const KeyMap stones{.kind = KeyMapKind::bars,
                        .lowestNote = 60,
                        .highestNote = 64,
                        .object = "Objects/stones/{note}.modal"};
    CHECK(found(stones, "b/x.json") == storedNameOf(testFolder() / "b" / stones.object));
    const auto& factory = factoryPresets().front();
    write("b/xylophone-65", "not this one");
    CHECK(withObjectsBeside(factory.keyMap, testFolder() / "b/x.json") == factory.keyMap);
    // A full path stays as it is, and a folder is not an object.
    const KeyMap full{.kind = KeyMapKind::zones, .object = storedNameOf(near)};
    CHECK(found(full, "c/x.json") == storedNameOf(near));
    const auto bell = write(std::filesystem::path("b") / u8"Glöckchen" / u8"γ.modal", "bell");
    const KeyMap greek{.kind = KeyMapKind::scaled,
                       .object = "Gl\xc3\xb6"
                                 "ckchen/\xce\xb3.modal"};
    CHECK(found(greek, "b/Bells/x.json") == storedNameOf(bell));
    const KeyMap none{.kind = KeyMapKind::zones, .object = ""};
    CHECK(found(none, "b/x.json").empty());
}

TEST_CASE("A file's name is the path by which a preset finds the file, if there is one") {
    const auto scene = write("n/Settings/Scenes/coins.json", "{}");
    const auto name = [&](const char* preset) { return nameBeside(scene, testFolder() / preset); };
    CHECK(name("n/Settings/Presets/x.json") == "Scenes/coins.json");
    CHECK(name("n/Settings/Presets/new/folders/x.json") == "Scenes/coins.json");
    CHECK(name("n/Settings/Scenes/x.json") == "coins.json");
    CHECK_FALSE(name("n/Settings/Presets/a/b/c/d/x.json"));
    CHECK_FALSE(nameBeside(testFolder() / "n/Settings/Scenes/none.json",
                           testFolder() / "n/Settings/Presets/x.json"));
    // A file of that name is nearer, so a longer path is needed.
    write("n/Settings/Presets/Scenes/coins.json", "{}");
    CHECK(name("n/Settings/Presets/x.json") == "Settings/Scenes/coins.json");
}

TEST_CASE("A file's name is normalised, and leads up from the preset only if the given path does") {
    write("m/Pack/Scenes/d.json", "{}");
    write("m/Pack/Presets/Scenes/e.json", "{}");
    const auto preset = testFolder() / "m/Pack/Presets/a.json";
    const auto again = [&](const char* name, const std::filesystem::path& savedAs) {
        const auto keyMap = withObjectsBeside({.kind = KeyMapKind::scene, .object = name}, preset);
        return nameBeside(pathNamed(keyMap.object), savedAs);
    };
    CHECK(again("../Scenes/d.json", preset) == "../Scenes/d.json");
    CHECK(again("../Scenes/d.json", testFolder() / "m/Pack/Mine/a.json") == "Scenes/d.json");
    CHECK(again("../Scenes/d.json", testFolder() / "m/a.json") == "Pack/Scenes/d.json");
    CHECK(again("./Scenes/d.json", preset) == "Scenes/d.json");
    CHECK(again("./Scenes/e.json", preset) == "Scenes/e.json");
}

TEST_CASE("A file's name leads back to the file through folders that are links") {
    const auto linked = write("l/Cloud/Scenes/d.json", "the linked folder's");
    write("l/Idiophone/Scenes/d.json", "the own folder's");
    std::filesystem::create_directories(testFolder() / "l/Cloud/Presets/Bells");
    std::error_code fault;
    std::filesystem::create_directory_symlink(testFolder() / "l/Cloud/Presets",
                                              testFolder() / "l/Idiophone/Presets", fault);
    if (fault)
        SKIP("no links here");
    const auto presets = testFolder() / "l/Idiophone/Presets";
    const auto found = [](const std::string& name, const std::filesystem::path& preset) {
        const KeyMap keyMap{.kind = KeyMapKind::scene, .object = name};
        return pathNamed(withObjectsBeside(keyMap, preset).object);
    };
    for (const char* written : {"../../Scenes/d.json", "../../Presets/../Scenes/d.json"}) {
        const auto scene = found(written, presets / "Bells/a.json");
        REQUIRE(std::filesystem::equivalent(scene, linked));
        for (const auto* savedAs : {"Bells/b.json", "Drums/b.json", "b.json"}) {
            const auto name = nameBeside(scene, presets / savedAs);
            const auto again =
                name ? found(*name, presets / savedAs) : std::filesystem::path(scene);
            CHECK(std::filesystem::equivalent(again, linked, fault));
        }
    }
}

TEST_CASE("The initial preset is plain, plays, and is as loud as the first factory preset") {
    const auto loudness = [](const Preset& preset) {
        const auto instrument = Instrument::build(preset.keyMap, ObjectLibrary::shared()).value();
        return predictedLufs({instrument, preset.surface, 48000}, preset.parameters) +
               preset.parameters[ParameterId::level];
    };
    const auto initial = initialPreset();
    CHECK(parsePreset(encodePreset(initial), "Init").value() == initial);
    auto plain = initial.parameters;
    plain.set(ParameterId::level, parameterInfo(ParameterId::level).defaultValue);
    CHECK(plain == ParameterValues());
    CHECK(std::abs(loudness(initial) - loudness(factoryPresets().front())) < 0.5);
}
