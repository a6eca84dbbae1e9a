// Tests of what the window says about files before and after they are dropped.
#include "Editor/DroppedFiles.h"

#include "Editor/EditorWindow.h"
#include "Editor/WindowParts.h"
#include "Instrument/FactoryContent.h"
#include "Plugin/Processor.h"
#include "Support/UserSettings.h"

#include <catch2/catch_test_macros.hpp>

using namespace idiophone;
using namespace idiophone::test;

TEST_CASE("Before a drop, the window says which files it opens or why it opens none") {
    Processor processor;
    const auto offer = [&](const juce::StringArray& files) {
        return DroppedFiles(files, processor.view()).offer();
    };
    CHECK(offer({"/home/me/teapot.obj"}) == "Drop to play teapot.obj");
    CHECK(offer({"/home/me/Teapot.GLB"}) == "Drop to play Teapot.GLB");
    CHECK(offer({"/a/letter.docx", "/a/teapot.obj"}) ==
          "Drop to play teapot.obj, without the other file");
    CHECK(offer({"/a/teapot.obj", "/a/cup.stl", "/a/meantone.scl"}) ==
          "Drop to play teapot.obj, without the other 2 files");
    CHECK(offer({"/a/meantone.scl"}) == "Drop to tune the keys to meantone.scl");
    CHECK(offer({"/a/meantone.scl", "/a/white.kbm"}) ==
          "Drop to tune the keys to meantone.scl and white.kbm");
    CHECK(offer({"/a/letter.docx"}) == "Idiophone cannot read .docx");
    CHECK(offer({"/a/README"}) == "Idiophone cannot read README");
    CHECK(offer({"/a/b.docx", "/a/c.DOCX"}) == "Idiophone cannot read .docx files");
    CHECK(offer({"/a/b.docx", "/a/c.png"}) == "Idiophone can read none of these 2 files");
    CHECK(offer({"/a/My bell.json"}) == "Drop to load the preset My bell");
    CHECK(offer({juce::File::getSpecialLocation(juce::File::tempDirectory).getFullPathName()}) ==
          "Idiophone opens files, not folders");
    CHECK(DroppedFiles({"/a/cup.stl"}, processor.view(), 61).offer() ==
          "Drop to play cup.stl on C#4");
    CHECK(DroppedFiles({"/a/My bell.json"}, processor.view(), 61).offer() ==
          "Drop to load the preset My bell");
}

TEST_CASE("The frame shows during a drag only, and an unreadable drop is refused in the status") {
    Processor processor;
    EditorWindow window(processor, processor.view());
    DropFrame* frame = nullptr;
    visit(window, [&](juce::Component& part) {
        if (auto* found = dynamic_cast<DropFrame*>(&part))
            frame = found;
    });
    REQUIRE(frame != nullptr);
    CHECK_FALSE(frame->isVisible());
    window.fileDragMove({"/a/teapot.obj"}, 5, 5);
    CHECK(frame->isVisible());
    CHECK(frame->shownSentence() == "Drop to play teapot.obj");
    // A key lies near the window's lower left corner.
    window.fileDragMove({"/a/teapot.obj"}, 30, window.getHeight() - 30);
    CHECK(frame->shownSentence().startsWith("Drop to play teapot.obj on C"));
    window.fileDragExit({"/a/teapot.obj"});
    CHECK_FALSE(frame->isVisible());
    window.fileDragMove({"/a/letter.docx"}, 5, 5);
    CHECK(frame->shownSentence() == "Idiophone cannot read .docx");
    window.filesDropped({"/a/letter.docx"}, 5, 5);
    CHECK_FALSE(frame->isVisible());
    const auto status = processor.view().status.takeStatus();
    CHECK(status.isError);
    CHECK(status.sentence.starts_with("\"letter.docx\" is not opened here"));
}

TEST_CASE("A dropped preset plays, and a JSON file that is no preset is refused in one sentence") {
    const UserSettings user;
    Processor processor;
    EditorWindow window(processor, processor.view());
    user.write("Bell.json", encodePreset(factoryPresets()[3]));
    user.write("other.json", "{}");
    window.filesDropped({fileOf(user.folder() / "Bell.json").getFullPathName()}, 5, 5);
    const auto& presets = processor.view().presets;
    CHECK(presets.playingPreset().details.name == factoryPresets()[3].name);
    CHECK(presets.playingPreset().id.empty()); // it is not on the shelf
    CHECK(processor.windowSession().history.canUndo());
    CHECK_FALSE(processor.view().status.takeStatus().isError);
    window.filesDropped({fileOf(user.folder() / "other.json").getFullPathName()}, 5, 5);
    CHECK(processor.view().status.takeStatus().isError);
    CHECK(presets.playingPreset().details.name == factoryPresets()[3].name);
}
