#include "Editor/Utf8.h"

#include "Plugin/FileKinds.h"

#include <catch2/catch_test_macros.hpp>

using namespace idiophone;

TEST_CASE("File names in any script convert between JUCE and the standard library") {
    const auto folder = juce::File::getSpecialLocation(juce::File::tempDirectory);
    for (const auto* name : {u8"Glöckchen.obj", u8"木琴.obj", u8"Ψαλτήριον.obj"}) {
        const auto file = folder.getChildFile(juce::String(name));
        const auto path = pathOf(file);
        CHECK(path.filename().u8string() == name);
        CHECK(fileOf(path) == file);
        CHECK(matches(path, objectFiles));
        CHECK(fileNameOf(path) == juce::String(name).toStdString());
    }
}
