#include "Plugin/HostSession.h"

#include "Instrument/FactoryContent.h"
#include "Plugin/RealTimeTrap.h"
#include "Plugin/SessionParts.h"

#include <array>
#include <thread>

using namespace idiophone;
using namespace idiophone::test;

namespace {

struct HostParts : SessionParts {
    TuningSession tuning{*this, session, history};
    HostSession hosted{*this, session, tuning};
};

} // namespace

TEST_CASE("A restored state plays at once and is saved as it was") {
    auto state = testState();
    state.parameters.set(ParameterId::density, 1234.5);
    state.tuning.scale = {.name = "two.scl", .text = "two\n2\n600.\n1200.\n"};
    const auto bytes = encodeState(state);
    HostParts parts;
    parts.session.prepare(48000, [](std::unique_ptr<Player>) {});
    parts.hosted.restore(bytes);
    CHECK(parts.takePlayer() != nullptr);
    CHECK(parts.loads.counted() == 1);
    CHECK(parts.parameters.values() == state.parameters);
    CHECK(parts.tuning.tuningStatus().source == TuningStatus::Source::files);
    CHECK(parts.hosted.save() == bytes);
}

TEST_CASE("The session's lock is free while a state's instrument and player are built") {
    if (!realTimeTrapWorks())
        SKIP("other threads cannot act at allocations here");
    const auto bytes = encodeState(testState());
    HostParts parts;
    parts.session.prepare(48000, [](std::unique_ptr<Player>) {});
    auto* const mutex = parts.session.lock().mutex();
    int allocations = 0, tried = 0, refused = 0;
    const auto tryLock = [&] {
        if (mutex->try_lock())
            mutex->unlock();
        else
            ++refused;
    };
    {
        const AtAllocations look([&] {
            if (++allocations % 20 != 0)
                return;
            ++tried;
            std::thread(tryLock).join();
        });
        parts.hosted.restore(bytes);
    }
    CHECK(parts.loads.counted() == 1);
    CHECK(tried > 100);
    CHECK(10 * refused < tried);
}

TEST_CASE("Bytes that are no state change nothing and are reported") {
    HostParts parts;
    parts.play();
    const auto before = parts.hosted.save();
    parts.hosted.restore("{}");
    CHECK(parts.hosted.save() == before);
    CHECK(parts.loads.counted() == 0);
    CHECK(parts.session.takeStatus().sentence == "The saved state is not one of Idiophone's.");
}

TEST_CASE("A program chosen by the host counts as a host load; one chosen by MIDI keeps the "
          "previous sound") {
    HostParts parts;
    parts.hosted.chooseProgram(1);
    CHECK(parts.session.program() == 1);
    CHECK(parts.loads.counted() == 1);
    parts.hosted.chooseProgram(-1);
    CHECK(parts.loads.counted() == 1);

    parts.programs.follow(std::array{MidiEvent{.sampleOffset = 0, .bytes = {0xc0, 0, 0}}});
    parts.hosted.followRequest();
    CHECK(parts.session.program() == 0);
    CHECK(parts.programs.pending() == ProgramChanges::none);
    CHECK(parts.loads.counted() == 1);
    const auto before = parts.loads.takeBeforePrograms();
    REQUIRE(before);
    CHECK(before->preset.name == factoryPresets()[1].name);
    CHECK_FALSE(parts.loads.takeBeforePrograms());
}
