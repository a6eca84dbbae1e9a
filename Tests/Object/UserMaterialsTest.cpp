// Tests of materials that are added to the user's folder.
#include "Object/MaterialFile.h"
#include "Support/UserSettings.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Matchers::ContainsSubstring;

namespace {

Material named(const std::string& name) {
    auto material = *findMaterial("Glass");
    material.name = name;
    return material;
}

} // namespace

TEST_CASE("An added material is found by its name, also with characters that no file can have") {
    const UserSettings user;
    for (const std::string name : {"Cup", "A/B: \"C\"?", "\xC3\x84sche"}) {
        const auto added = addUserMaterial(named(name));
        REQUIRE(added);
        CHECK(*added == named(name));
        CHECK(findAnyMaterial(name) == *added);
    }
    CHECK(std::filesystem::exists(userMaterialFolder() / "A-B- -C--.json"));
}

TEST_CASE("An added material replaces no other, whatever the case of its name or file") {
    const UserSettings user;
    user.write("Materials/Cup 2.json", "{"); // damaged, and not to be lost
    user.write("Materials/other.json", encodeMaterial(named("CUP")));
    CHECK(addUserMaterial(named("Cup"))->name == "Cup 3");
    CHECK(addUserMaterial(named("Cup"))->name == "Cup 4");
    CHECK(addUserMaterial(named("steel"))->name == "steel 2"); // the library has one
    CHECK(user.read("Materials/Cup 2.json") == "{");
}

TEST_CASE("A material that could not be read again, or has no place, is not added") {
    const UserSettings user;
    const auto tooLong = addUserMaterial(named(std::string(150, 'x')));
    REQUIRE_FALSE(tooLong);
    CHECK_THAT(tooLong.error().message, ContainsSubstring("longer than"));
    CHECK(readMaterialFolder(userMaterialFolder()).materials.empty());
    std::filesystem::remove(userMaterialFolder());
    std::ofstream(userMaterialFolder()) << "a file in the place of the folder";
    const auto nowhere = addUserMaterial(named("Cup"));
    REQUIRE_FALSE(nowhere);
    CHECK_THAT(nowhere.error().message, ContainsSubstring("the folder cannot be made"));
}
