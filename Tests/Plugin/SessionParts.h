// The sessions and what they need, without a processor, a window or an engine.
#pragma once

#include "Plugin/BareHost.h"
#include "Plugin/ObjectEmbedding.h"
#include "Plugin/SoundHistory.h"
#include "Plugin/SoundSession.h"
#include "Support/TestSound.h"

#include <catch2/catch_test_macros.hpp>

namespace idiophone::test {

/// Returns the sound of `testState(folder)`.
inline Sound testSound(const std::string& folder = "test") {
    const auto state = testState(folder);
    auto built = buildInstrument(state.preset.keyMap, state.objects);
    REQUIRE(built);
    return {.preset = state.preset,
            .instrument = *built,
            .parameters = state.parameters,
            .stored = state.parameters};
}

struct HostOfParts {
    BareHost host;
};

struct SessionParts : HostOfParts, SharedParts {
    static constexpr double rateHz = 48000;

    SessionParts() : SharedParts(host, 2, [] {}) {}

    /// Prepares the session with this sound.
    void play(const Sound& sound = testSound()) {
        session.prepare(rateHz, [](std::unique_ptr<Player>) {});
        REQUIRE(session.playSound(sound));
    }
    /// Takes the player as the engine would.
    std::unique_ptr<Player> takePlayer() {
        return std::unique_ptr<Player>(messages.players.take());
    }

    SoundSession session{*this};
    SoundHistory history{session, parameters, loads};
};

} // namespace idiophone::test
