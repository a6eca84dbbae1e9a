#include "Plugin/PresetFolder.h"

#include "Editor/Utf8.h"
#include "Instrument/FactoryContent.h"
#include "Support/HomeFolder.h"
#include "Support/TestFolder.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <fstream>
#include <random>
#include <set>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Matchers::ContainsSubstring;

namespace {

juce::File freshFolder() {
    const auto folder = juce::File(testFolder().string()).getChildFile("Presets");
    folder.deleteRecursively();
    return folder;
}

Preset named(const std::string& name) {
    auto preset = factoryPresets()[3];
    preset.name = name;
    return preset;
}

using Ids = std::set<std::string>;

Ids idsOf(PresetFolder& folder) {
    Ids ids;
    for (const auto& entry : folder.read())
        CHECK(ids.insert(entry.id).second);
    return ids;
}

template <class Outcome>
void checkRefused(const Outcome& outcome) {
    REQUIRE_FALSE(outcome);
    CHECK(outcome.error().message.back() == '.');
}

} // namespace

TEST_CASE("A missing folder has no presets, and reading does not create it") {
    const auto root = freshFolder();
    PresetFolder folder(root);
    CHECK(folder.read().empty());
    CHECK_FALSE(root.exists());
    CHECK(PresetFolder(juce::File()).read().empty());
}

TEST_CASE("Written presets are read back equal, sorted by folder and name") {
    const auto root = freshFolder();
    PresetFolder folder(root);
    CHECK(folder.write(named("zebra"), "", false).value() == "zebra.json");
    CHECK(folder.write(named("Ärger: 7/8?"), "Bells/Small", false).value() ==
          "Bells/Small/Ärger 78.json");
    CHECK(folder.write(named("Apple"), "", false).value() == "Apple.json");
    const auto& entries = folder.read();
    REQUIRE(entries.size() == 3);
    CHECK(entries[0].preset.value() == named("Apple"));
    CHECK(entries[1].preset.value() == named("zebra"));
    CHECK(entries[2].preset.value() == named("Ärger: 7/8?"));
    CHECK(entries[2].folder == "Bells/Small");
    PresetFolder other(root);
    CHECK(other.read().size() == 3);
}

TEST_CASE("A preset is replaced only on request, and then completely") {
    PresetFolder folder(freshFolder());
    REQUIRE(folder.write(named("One"), "", false));
    auto second = named("One");
    second.description = "another";
    const auto refused = folder.write(second, "", false);
    checkRefused(refused);
    CHECK_THAT(refused.error().message, ContainsSubstring("'One'"));
    CHECK(folder.read().front().preset.value() == named("One"));
    REQUIRE(folder.write(second, "", true));
    CHECK(folder.read().front().preset.value() == second);
    CHECK(folder.fileOf("One.json")
              .getParentDirectory()
              .getNumberOfChildFiles(juce::File::findFiles) == 1);
}

TEST_CASE("A preset stays in its folder for any folder name and can be saved there again") {
    const auto root = freshFolder();
    const std::string inFolder = "Marimba, 442 Hz/Bells #2";
    const auto place = root.getChildFile(fromUtf8(inFolder));
    place.getChildFile("bell.modal").create();
    PresetFolder folder(root);
    REQUIRE(folder.write(named("One"), inFolder, false).value() == inFolder + "/One.json");
    folder.read();
    CHECK(folder.rename(inFolder + "/One.json", "Two").value() == inFolder + "/Two.json");
    folder.read();
    CHECK(folder.write(named("Two"), inFolder, true).value() == inFolder + "/Two.json");
    CHECK(place.getNumberOfChildFiles(juce::File::findFiles) == 2);
    CHECK(root.getNumberOfChildFiles(juce::File::findDirectories) == 1);
}

#ifndef _WIN32 // there a tilde is a letter like others
TEST_CASE("A name that begins with a tilde is not taken for a home path") {
    const HomeFolder home;
    const auto root = freshFolder();
    PresetFolder folder(root);
    juce::File("~/mine").createDirectory();
    CHECK(folder.write(named("~One"), "~", false).has_value() == false);
    CHECK(folder.write(named("~One"), "~mine", false).value() == "mine/One.json");
}
#endif

TEST_CASE("Impossible file names are refused, and no name leads out of the folder") {
    const auto root = freshFolder();
    PresetFolder folder(root);
    for (const auto* name : {"", "   ", "///", "~", "..", ".", "\\", "???"}) {
        INFO(name);
        checkRefused(folder.write(named(name), "", false));
    }
    checkRefused(folder.write(named(std::string(300, 'x')), "", false));
    checkRefused(folder.write(named("x"), "Objects", false));
    checkRefused(folder.write(named("x"), "a/b/c/d/e", false));
    checkRefused(folder.write(named("x"), "..", false));
    CHECK_FALSE(root.exists());
    for (const auto* name : {"../../x", "/etc/x", "C:\\x", "..\\x", "a\nb"}) {
        INFO(name);
        const auto id = folder.write(named(name), "", true);
        REQUIRE(id);
        CHECK(folder.fileOf(*id).isAChildOf(root));
        CHECK(folder.fileOf(*id).getParentDirectory() == root);
    }
}

TEST_CASE("A folder that cannot be written gives an error of one sentence") {
    const auto root = freshFolder();
    root.create(); // a file in place of the folder
    PresetFolder folder(root);
    checkRefused(folder.write(named("One"), "", false));
    checkRefused(folder.folder());
    CHECK(folder.read().empty());
    root.deleteFile();
}

TEST_CASE("Broken files stay listed with one sentence that names them") {
    const auto root = freshFolder();
    PresetFolder folder(root);
    REQUIRE(folder.write(named("Good"), "", false));
    root.getChildFile("empty.json").create();
    root.getChildFile("noise.json").replaceWithText("\x01{[");
    root.getChildFile("huge.json").replaceWithText(juce::String::repeatedString("x", 2 << 20));
    root.getChildFile("later.json")
        .replaceWithText(R"({"format":"idiophone-preset","version":9,"name":"x"})");
    root.getChildFile("deep.json")
        .replaceWithText(juce::String::repeatedString("[", 100000) +
                         juce::String::repeatedString("]", 100000));
    root.getChildFile("folder.json").createDirectory();
    root.getChildFile("notes.txt").create();
    int broken = 0;
    for (const auto& entry : folder.read()) {
        if (entry.preset)
            continue;
        ++broken;
        CHECK_THAT(entry.preset.error().message, ContainsSubstring(entry.id));
        const auto renamed = folder.rename(entry.id, "New name");
        REQUIRE_FALSE(renamed);
        CHECK(renamed.error().message == entry.preset.error().message);
        CHECK(folder.fileOf(entry.id).existsAsFile());
    }
    CHECK(broken == 5);
}

TEST_CASE("A changed file is read again, and a deleted one disappears") {
    const auto root = freshFolder();
    PresetFolder folder(root);
    REQUIRE(folder.write(named("One"), "", false));
    CHECK(folder.read().size() == 1);
    root.getChildFile("One.json").replaceWithText("{}");
    CHECK_FALSE(folder.read().front().preset);
    root.getChildFile("One.json").deleteFile();
    CHECK(folder.read().empty());
    CHECK(folder.find("One.json") == nullptr);
}

TEST_CASE("Folders that are too deep, circular links and objects are skipped") {
    const auto root = freshFolder();
    PresetFolder folder(root);
    REQUIRE(folder.write(named("Deep"), "a/b/c/d", false));
    REQUIRE(folder.write(named("Top"), "", false));
    const auto file = folder.fileOf("Top.json");
    for (const auto* unseen :
         {"a/b/c/d/e/Deeper.json", "Objects/hidden.json", "objects/hidden.json"}) {
        root.getChildFile(unseen).create();
        REQUIRE(file.copyFileTo(root.getChildFile(unseen)));
    }
    root.createSymbolicLink(root.getChildFile("a/b/again"), true);
    CHECK(idsOf(folder) == Ids{"Top.json", "a/b/c/d/Deep.json"});
}

TEST_CASE("A link to a folder elsewhere is followed") {
    const auto root = freshFolder();
    const auto elsewhere = juce::File(testFolder().string()).getChildFile("shared presets");
    PresetFolder folder(root);
    REQUIRE(folder.write(named("Own"), "", false));
    REQUIRE(PresetFolder(elsewhere).write(named("Shared"), "Bells", false));
    elsewhere.createSymbolicLink(root.getChildFile("link"), true);
    CHECK(idsOf(folder) == Ids{"Own.json", "link/Bells/Shared.json"});
}

TEST_CASE("Presets are found beside objects and linked folders that exceed the scan limit") {
    const auto root = freshFolder();
    const auto large = juce::File(testFolder().string()).getChildFile("large");
    constexpr int maximumEntries = 100;
    PresetFolder folder(root, maximumEntries);
    REQUIRE(folder.write(named("Own"), "a/b/c/d", false));
    const Ids own{"a/b/c/d/Own.json"};
    REQUIRE(PresetFolder(large).write(named("Far"), "in", false));
    for (int i = 0; i < maximumEntries; ++i)
        std::ofstream(pathOf(large) / (std::to_string(i) + ".txt"));
    const auto link = root.getChildFile("0");
    large.createSymbolicLink(link, true);
    CHECK(idsOf(folder) == own);
    link.deleteFile();
    REQUIRE(large.moveFileTo(root.getChildFile("Objects")));
    CHECK(idsOf(folder) == own);
}

TEST_CASE("A renamed preset keeps its folder and its sound") {
    const auto root = freshFolder();
    PresetFolder folder(root);
    const auto id = folder.write(named("One"), "Bells", false).value();
    folder.read();
    const auto renamed = folder.rename(id, "Two");
    REQUIRE(renamed);
    CHECK(*renamed == "Bells/Two.json");
    CHECK_FALSE(folder.fileOf(id).exists());
    REQUIRE(folder.read().size() == 1);
    CHECK(folder.read().front().preset.value() == named("Two"));
    // The new name differs only in letters that file names cannot have.
    CHECK(folder.rename(*renamed, "Two?").value() == *renamed);
    CHECK(folder.read().front().preset->name == "Two?");
}

TEST_CASE("A preset replaces its file even if the file has another name") {
    PresetFolder folder(freshFolder());
    auto first = named("One");
    first.keyMap.referenceNote = 60;
    const auto id = folder.write(first, "Bells", false).value();
    folder.read();
    auto changed = named("Other");
    changed.seed = 77;
    changed.parameters.set(ParameterId::tau, 3);
    REQUIRE(folder.replace(id, changed));
    REQUIRE(folder.read().size() == 1);
    CHECK(folder.find(id)->preset.value() == changed); // without the reference note
    checkRefused(folder.replace("Two.json", changed));
    checkRefused(folder.replace("../One.json", changed));
    CHECK(folder.read().size() == 1);
}

TEST_CASE("A preset too large for a file is not written") {
    PresetFolder folder(freshFolder());
    auto large = named("One");
    REQUIRE(large.mutedModes.set(std::string(largestPresetBytes, 'x'), 0, true));
    checkRefused(folder.write(large, "", false));
    CHECK(folder.read().empty());
}

TEST_CASE("A change by another instance is noticed even at equal size and time") {
    const auto root = freshFolder();
    PresetFolder folder(root), other(root);
    const auto id = folder.write(named("One"), "", false).value();
    folder.read();
    const auto content = folder.find(id)->content;
    const auto file = folder.fileOf(id);
    const auto time = file.getLastModificationTime();
    CHECK(folder.checkContent(id, content));
    other.read();
    auto changed = named("One");
    changed.seed = changed.seed == 2 ? 3 : 2;
    REQUIRE(other.replace(id, changed));
    file.setLastModificationTime(time);
    const auto refused = folder.checkContent(id, content);
    checkRefused(refused);
    CHECK_THAT(refused.error().message, ContainsSubstring("One.json was changed elsewhere"));
    // From then on the list has the changed file.
    CHECK(folder.read().front().preset->seed == changed.seed);
    CHECK(folder.checkContent(id, folder.find(id)->content));
    REQUIRE(other.rename(id, "Two"));
    const auto gone = folder.checkContent(id, folder.find(id)->content);
    checkRefused(gone);
    CHECK_THAT(gone.error().message, ContainsSubstring("One.json was renamed, moved or deleted"));
}

TEST_CASE("The folder's own writes are read again even at equal size and time") {
    const auto root = freshFolder();
    PresetFolder folder(root);
    const auto id = folder.write(named("One"), "", false).value();
    for (int seed = 2; seed < 9; ++seed) {
        folder.read();
        auto changed = named("One");
        changed.seed = static_cast<std::uint32_t>(seed);
        REQUIRE((seed % 2 == 0 ? folder.replace(id, changed)
                               : folder.write(changed, "", true).map([](const auto&) {})));
        CHECK(folder.read().front().preset->seed == changed.seed);
        CHECK(folder.checkContent(id, folder.find(id)->content));
    }
}

TEST_CASE("A rename onto another preset, of a missing preset, or to no name changes nothing") {
    PresetFolder folder(freshFolder());
    REQUIRE(folder.write(named("One"), "", false));
    REQUIRE(folder.write(named("Two"), "", false));
    folder.read();
    checkRefused(folder.rename("One.json", "Two"));
    checkRefused(folder.rename("One.json", "/"));
    checkRefused(folder.rename("Three.json", "Four"));
    checkRefused(folder.rename("../Presets/One.json", "Four"));
    CHECK(folder.read().size() == 2);
    CHECK(folder.find("One.json")->preset.value() == named("One"));
}

TEST_CASE("Deleted presets go to the bin, also two with the same name") {
#if JUCE_LINUX
    const HomeFolder home; // and so the bin
    const auto bin =
        juce::File((testFolder() / "home").string()).getChildFile(".local/share/Trash");
    PresetFolder folder(freshFolder());
    for (int i = 0; i < 2; ++i) {
        REQUIRE(folder.write(named("One"), "", false));
        folder.read();
        REQUIRE(folder.moveToBin("One.json"));
        CHECK(folder.read().empty());
        checkRefused(folder.moveToBin("One.json"));
    }
    CHECK(bin.getChildFile("files").getNumberOfChildFiles(juce::File::findFiles, "One*.json") == 2);
#endif
}

TEST_CASE("Random files in the folder never crash the reader") {
    const auto root = freshFolder();
    PresetFolder folder(root);
    const auto good = encodePreset(named("One"));
    std::mt19937 random(5);
    for (int i = 0; i < 200; ++i) {
        auto damaged = good;
        for (int flip = 0; flip < 4; ++flip)
            damaged[random() % damaged.size()] = static_cast<char>(random());
        root.createDirectory();
        root.getChildFile("f" + juce::String(i) + ".json")
            .replaceWithData(damaged.data(),
                             1 + random() % damaged.size()); // zero bytes would delete the file
    }
    CHECK(folder.read().size() == 200);
}
