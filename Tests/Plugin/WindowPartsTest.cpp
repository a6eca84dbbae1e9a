// The parts that the window uses, each built without a processor.
#include "Plugin/ImportSession.h"
#include "Plugin/InstrumentSession.h"
#include "Plugin/ModeSession.h"
#include "Plugin/SessionParts.h"
#include "Plugin/StageSession.h"
#include "Support/GestureLog.h"
#include "Support/ImportedFiles.h"
#include "Support/UserSettings.h"

#include <functional>

using namespace idiophone;
using namespace idiophone::test;
using enum ParameterId;

namespace {

struct EditParts : SessionParts {
    EditParts() { play(); }
    ParameterEdits edits{host, parameters, session, history};
    MaterialSession materials{parameters, session, history, edits};
};

/// Returns the player's peak after the window's events.
float peakAfterEvents(SessionParts& parts, Player& player) {
    std::vector<MidiEvent> notes;
    parts.messages.window.read(&player, [&](const MidiEvent& note) { notes.push_back(note); });
    std::vector<float> left(4800), right(4800);
    player.process({left, right}, notes, parts.parameters.values());
    return loudest(left);
}

} // namespace

TEST_CASE("A nested change is one gesture for the host and one step of the history") {
    EditParts parts;
    GestureLog log;
    parts.host.addListener(&log);
    const double before = parts.edits.value(density);
    parts.edits.beginChange(density);
    parts.edits.beginChange(density);
    parts.edits.change(density, 1234);
    parts.edits.endChange(density);
    parts.edits.endChange(density);
    CHECK(log.text == "(=)");
    CHECK(parts.edits.value(density) == 1234);
    parts.history.undo();
    CHECK(parts.edits.value(density) == before);
    CHECK_FALSE(parts.history.canUndo());
    parts.host.removeListener(&log);
}

TEST_CASE("A closed window ends its gestures") {
    EditParts parts;
    GestureLog log;
    parts.host.addListener(&log);
    parts.edits.beginChange(density);
    parts.edits.beginChange(density);
    parts.edits.endAllChanges();
    CHECK(log.text == "()");
    parts.edits.endChange(density);
    CHECK(log.text == "()");
    parts.host.removeListener(&log);
}

TEST_CASE("A material made custom keeps the figures that it had") {
    EditParts parts;
    const double inEffect = parts.edits.effectiveValue(density);
    parts.edits.makeCustom(density);
    CHECK(parts.edits.value(material) == double(customMaterial));
    CHECK(parts.edits.value(density) == inEffect);
    CHECK(parts.edits.isLive(density));
}

TEST_CASE("Without materials of the user none is chosen") {
    const UserSettings user;
    EditParts parts;
    CHECK(parts.materials.readUserMaterials().empty());
    CHECK(parts.materials.userMaterialIndex() == -1);
    const auto before = parts.parameters.values();
    parts.materials.chooseUserMaterial(0);
    CHECK(parts.parameters.values() == before);
    CHECK_FALSE(parts.materials.contains("Steel"));
}

TEST_CASE("The window plays keys and objects only while the host calls the engine") {
    SessionParts parts;
    parts.play();
    const auto player = parts.takePlayer();
    InstrumentSession window(parts, parts.session);
    CHECK(window.keyRange().lowest == lowestTestNote);
    CHECK(window.keySounds()[lowestTestNote] == InstrumentView::KeySound::own);
    CHECK(window.keySounds()[lowestTestNote - 1] == InstrumentView::KeySound::silent);
    CHECK(window.playedObjects().size() == 13);
    CHECK(window.struckPlaces(0).size() > 0);
    CHECK(window.struckPlaces(13).empty());
    CHECK_FALSE(parts.session.takeStatus().isError);
    window.playNote(65, 100);
    CHECK(peakAfterEvents(parts, *player) == 0);
    CHECK(parts.session.takeStatus().sentence.starts_with("Strikes in the window are silent"));
    ++parts.report.callbacks;
    REQUIRE(window.isProcessing());
    window.poll();
    CHECK_FALSE(parts.session.takeStatus().isError);
    window.playNote(65, 100);
    CHECK(peakAfterEvents(parts, *player) > 0);
    player->reset();
    window.strikeObject(3, {0, 0, 0}, 100);
    CHECK(peakAfterEvents(parts, *player) > 0);
    player->reset();
    window.strikeObject(13, {0, 0, 0}, 100);
    CHECK(peakAfterEvents(parts, *player) == 0);
}

TEST_CASE("When the host goes on, only the sentence about its pause is removed") {
    SessionParts parts;
    parts.play();
    InstrumentSession window(parts, parts.session);
    window.strikeObject(3, {0, 0, 0}, 100);
    parts.session.reportError("It fails.");
    ++parts.report.callbacks;
    window.poll();
    CHECK(parts.session.takeStatus().sentence == "It fails.");
}

TEST_CASE("Without a stage there is nothing to show, pause or capture") {
    SessionParts parts;
    parts.play();
    StageSession stage(parts, parts.session);
    CHECK_FALSE(stage.hasStage());
    CHECK(stage.stageBodies().empty());
    CHECK_FALSE(stage.hasCaptured());
    stage.pauseStage(true);
    CHECK(stage.isStagePaused());
    REQUIRE(parts.session.playSound(testSound("other")));
    CHECK_FALSE(stage.isStagePaused());
    CHECK_FALSE(stage.writeCapture(StageView::CaptureKind::midi, testFolder() / "none.mid"));
    CHECK(parts.session.takeStatus().isError);
}

TEST_CASE("Muting a mode is a step of the history and reaches the player") {
    SessionParts parts;
    parts.play();
    const auto player = parts.takePlayer();
    ModeSession modes(parts, parts.session, parts.history);
    const auto peak = [&] {
        parts.messages.silencer.silence(player.get());
        player->reset();
        parts.messages.window.pushNote(lowestTestNote, 100);
        return peakAfterEvents(parts, *player);
    };
    const float whole = peak();
    for (int mode = 0; mode < 12; ++mode)
        CHECK(modes.muteMode(0, mode, true));
    CHECK(peak() == 0);
    CHECK_FALSE(modes.muteMode(0, 12, true));
    CHECK_FALSE(modes.muteMode(13, 0, true));
    modes.unmuteModes(0);
    CHECK(peak() == whole);
    parts.history.undo();
    CHECK(peak() == 0);
    parts.history.redo();
    CHECK(modes.hearModeAlone(0, 3, true));
    const float alone = peak();
    CHECK(alone > 0);
    CHECK(alone != whole);
    modes.hearAllModes(0);
    CHECK(peak() == whole);
}

TEST_CASE("An opened object plays, and its keys can be laid along a path") {
    EditParts parts;
    ImportSession imports(parts, parts.session, parts.history, parts.materials);
    CHECK_FALSE(imports.keyLayout());
    const auto state = testState();
    const auto& modal = state.objects.front().modal;
    const auto file =
        writtenFile("bar.modal", {reinterpret_cast<const char*>(modal.data()), modal.size()});
    REQUIRE(imports.canOpen(file));
    imports.openFile(file);
    waitUntil([&] { return !imports.importStatus().isWorking(); });
    CHECK(imports.importStatus().error == "");
    imports.poll();
    CHECK(parts.session.loadedSound().preset.tags == std::vector<std::string>{"imported"});
    CHECK(imports.keyLayout() == KeyLayout::scaled);
    CHECK_FALSE(imports.playsPreview());
    const int origin = parts.session.origin();
    imports.setKeyLayout(KeyLayout::zones);
    CHECK(imports.keyLayout() == KeyLayout::zones);
    parts.history.undo();
    CHECK(imports.keyLayout() == KeyLayout::scaled);
    CHECK(parts.session.origin() > origin);
    parts.history.undo();
    CHECK_FALSE(imports.keyLayout());
}
