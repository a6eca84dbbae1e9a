// The user's files when the disk is full.
#include "Plugin/WholeFile.h"
#include "Instrument/ObjectLibrary.h"

#include "Editor/Utf8.h"
#include "Instrument/FactoryContent.h"
#include "Plugin/Favourites.h"
#include "Plugin/PresetFolder.h"
#include "Plugin/PresetObjects.h"
#include "Plugin/StageCapture.h"
#include "Scene/SceneStage.h"
#include "Support/FullDisk.h"
#include "Support/SyntheticObject.h"
#include "Support/TestFolder.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <filesystem>
#include <vector>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Matchers::EndsWith;
using Catch::Matchers::StartsWith;

namespace {

juce::File freshFolder() {
    const auto folder = juce::File(testFolder().string()).getChildFile("written");
    folder.deleteRecursively();
    return folder;
}

/// Checks for an error of one sentence that begins with the file's path.
template <class Outcome>
void checkRefused(const Outcome& outcome, const juce::File& file) {
    REQUIRE_FALSE(outcome);
    CHECK_THAT(outcome.error().message, StartsWith(file.getFullPathName().toStdString()));
    CHECK_THAT(outcome.error().message, EndsWith("."));
}

/// Counts all files below the folder, including hidden ones.
int files(const juce::File& folder) {
    return folder.findChildFiles(juce::File::findFiles, true).size();
}

} // namespace

TEST_CASE("A file that cannot be written gives an error of one sentence with its path") {
    const auto folder = freshFolder();
    const auto blocked = folder.getChildFile("a file/x");
    blocked.getParentDirectory().create();
    const std::vector<std::byte> bytes(10);
    checkRefused(writeWhole(blocked, bytes), blocked);
    const auto directory = folder.getChildFile("a folder");
    directory.getChildFile("with something in it").create();
    checkRefused(writeWhole(directory, bytes), directory);
    CHECK(files(folder) == 2);
}

#ifndef _WIN32

TEST_CASE("A protected file is kept, and a replaced file keeps its permissions and links") {
    const auto folder = freshFolder();
    const auto file = folder.getChildFile("behind/file"), link = folder.getChildFile("link");
    const std::vector<std::byte> bytes(10), more(20);
    REQUIRE(writeWhole(file, bytes));
    REQUIRE(file.createSymbolicLink(link, false));
    const auto permissions = [&] { return std::filesystem::status(pathOf(file)).permissions(); };
    using std::filesystem::perms;
    std::filesystem::permissions(pathOf(file), perms::owner_read | perms::owner_write);
    REQUIRE(writeWhole(link, more));
    CHECK(link.isSymbolicLink());
    CHECK(file.getSize() == 20);
    CHECK(permissions() == (perms::owner_read | perms::owner_write));
    std::filesystem::permissions(pathOf(file), perms::owner_read);
    checkRefused(writeWhole(link, bytes), link);
    CHECK(file.getSize() == 20);
    std::filesystem::permissions(pathOf(file), perms::owner_all);
}

namespace {

template <class Write>
auto onFullDisk(rlim_t bytesOfFile, const Write& write) {
    const FullDisk disk(bytesOfFile);
    return write();
}

Preset longPreset(const std::string& name) {
    auto preset = factoryPresets()[3];
    preset.name = name;
    preset.description = std::string(2000, 'x');
    return preset;
}

/// Space for no byte, or for the beginning of every file in these tests.
rlim_t roomInBytes() {
    return GENERATE(rlim_t{0}, rlim_t{16});
}

} // namespace

TEST_CASE("A file and its folder are written completely, or the old file is kept") {
    const auto folder = freshFolder();
    const auto file = folder.getChildFile("deeper/bytes");
    const auto write = [&](std::size_t count) {
        const std::vector<std::byte> bytes(count, std::byte{7});
        return writeWhole(file, bytes);
    };
    REQUIRE(write(100'000));
    CHECK(file.getSize() == 100'000);
    REQUIRE(write(2000));
    CHECK(file.getSize() == 2000);
    // Short and long files are buffered differently by a stream.
    for (const std::size_t count : {3000u, 100'000u})
        for (const rlim_t room : {0, 1024}) {
            CAPTURE(count, room);
            checkRefused(onFullDisk(room, [&] { return write(count); }), file);
            CHECK(file.getSize() == 2000);
            CHECK(files(folder) == 1);
        }
    REQUIRE(onFullDisk(1024, [&] { return write(1024); }));
    CHECK(file.getSize() == 1024);
    CHECK(files(folder) == 1);
}

TEST_CASE("On a full disk a preset is neither replaced nor renamed, and no partial file remains") {
    const auto room = roomInBytes();
    const auto root = freshFolder();
    PresetFolder folder(root);
    REQUIRE(folder.write(longPreset("One"), "", false));
    auto other = longPreset("One");
    other.description += "another";
    checkRefused(onFullDisk(room, [&] { return folder.write(other, "", true); }),
                 root.getChildFile("One.json"));
    folder.read();
    checkRefused(onFullDisk(room, [&] { return folder.rename("One.json", "Two"); }),
                 root.getChildFile("Two.json"));
    REQUIRE(folder.read().size() == 1);
    CHECK(folder.read().front().preset.value() == longPreset("One"));
    CHECK(files(root) == 1);
}

TEST_CASE("On a full disk no partial object file remains") {
    const auto room = roomInBytes();
    const auto root = freshFolder();
    ObjectLibrary library;
    const auto kept = library.add("bowl.modal", syntheticObject({300, 900}));
    const KeyMap map{
        .kind = KeyMapKind::scaled, .lowestNote = 48, .highestNote = 60, .object = "bowl.modal"};
    const auto bowl = Instrument::build(map, library).value();
    checkRefused(onFullDisk(room, [&] { return writePresetObjects(map, *bowl, root); }),
                 root.getChildFile("Objects"));
    CHECK(files(root) == 0);
}

TEST_CASE("On a full disk the favourites stay unchanged") {
    const auto room = roomInBytes();
    const auto file = freshFolder().getChildFile("favourites.json");
    Favourites favourites(file);
    REQUIRE(favourites.set("factory:Wok", true));
    checkRefused(onFullDisk(room, [&] { return favourites.set("factory:Gong", true); }), file);
    CHECK(favourites.read() == std::set<std::string>{"factory:Wok"});
}

#endif
