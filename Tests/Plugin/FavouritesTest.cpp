#include "Plugin/Favourites.h"

#include "Support/TestFolder.h"

#include <catch2/catch_test_macros.hpp>

using namespace idiophone;
using namespace idiophone::test;
using Ids = std::set<std::string>;

namespace {

/// Returns a file that does not exist yet.
juce::File freshFile() {
    const auto file =
        juce::File(testFolder().string()).getChildFile("settings").getChildFile("favourites.json");
    file.getParentDirectory().deleteRecursively();
    return file;
}

} // namespace

TEST_CASE("Favourites are kept in the file, and another instance sees them") {
    const auto file = freshFile();
    Favourites first(file), second(file);
    CHECK(first.read().empty());
    REQUIRE(first.set("factory:Wok", true));
    REQUIRE(second.set("Bells/Größe \"9\".json", true));
    CHECK(first.read() == Ids{"factory:Wok", "Bells/Größe \"9\".json"});
    REQUIRE(first.set("factory:Wok", false));
    REQUIRE(first.set("never there", false));
    CHECK(second.read() == Ids{"Bells/Größe \"9\".json"});
    REQUIRE(second.rename("Bells/Größe \"9\".json", "Bells/Ten.json"));
    REQUIRE(second.rename("never there", "nor here"));
    CHECK(first.read() == Ids{"Bells/Ten.json"});
}

TEST_CASE("A damaged file has no favourites and is renamed when new ones are written") {
    for (const auto* damage : {"", "{", "[]", "7", R"({"format": 3})",
                               R"({"format": "idiophone-favourites", "presets": "all"})"}) {
        const auto file = freshFile();
        file.create();
        file.replaceWithText(damage);
        Favourites favourites(file);
        CHECK(favourites.read().empty());
        CHECK(file.loadFileAsString() == damage);
        REQUIRE(favourites.set("factory:Wok", true));
        CHECK(favourites.read() == Ids{"factory:Wok"});
        const auto kept = file.getSiblingFile("favourites damaged.json");
        CHECK(kept.existsAsFile());
        CHECK(kept.loadFileAsString() == damage);
    }
}

TEST_CASE("Without a writable settings folder a change fails with one sentence") {
    Favourites nowhere{juce::File()};
    CHECK(nowhere.read().empty());
    const auto refused = nowhere.set("factory:Wok", true);
    REQUIRE_FALSE(refused);
    CHECK(refused.error().message.back() == '.');

    const auto blocked = freshFile();
    blocked.getParentDirectory().create(); // a file in place of the folder
    CHECK_FALSE(Favourites(blocked).set("factory:Wok", true));
    blocked.getParentDirectory().deleteFile();
}
