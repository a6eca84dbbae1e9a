#include "Plugin/TuningSession.h"

#include "Plugin/SessionParts.h"
#include "Support/ImportedFiles.h"

using namespace idiophone;
using namespace idiophone::test;
using Source = TuningStatus::Source;

TEST_CASE("An opened scale tunes the player, can be undone, and can be forgotten") {
    SessionParts parts;
    parts.play();
    TuningSession tuning(parts, parts.session, parts.history);
    const auto player = parts.takePlayer();
    const auto semitonesBelow = [&] {
        parts.messages.tuner.tune(player.get());
        std::array<float, 64> left, right;
        player->process({left, right}, {}, parts.parameters.values());
        return player->semitonesBelowEqual();
    };
    const double equal = semitonesBelow();
    const auto file = writtenFile("half.scl", "half\n1\n50.\n");
    CHECK(tuning.isTuningFile(file));
    tuning.openTuning(file);
    CHECK(tuning.tuningStatus().source == Source::files);
    CHECK(semitonesBelow() != equal);
    parts.history.undo();
    CHECK(tuning.tuningStatus().source == Source::equal);
    CHECK(semitonesBelow() == equal);
    parts.history.redo();
    CHECK(tuning.tuningStatus().scale == "half");
    tuning.forgetTuning();
    CHECK(tuning.tuningStatus().source == Source::equal);
}

TEST_CASE("A file that is no scale leaves the tuning unchanged and is reported") {
    SessionParts parts;
    TuningSession tuning(parts, parts.session, parts.history);
    tuning.openTuning(writtenFile("bad.scl", "no scale"));
    CHECK(tuning.tuningStatus().source == Source::equal);
    CHECK(parts.session.takeStatus().isError);
    CHECK_FALSE(parts.history.canUndo());
}
