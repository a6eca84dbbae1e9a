#include "Plugin/PlayInstead.h"

#include <utility>

namespace idiophone {

std::optional<int> playInstead(SharedParts& shared,
                               SoundSession& session,
                               const SoundSession::Loaded& now,
                               const Sound& wanted,
                               LoadOrigin origin) {
    int number;
    {
        const auto held = session.lock();
        if (session.number() != now.number)
            return std::nullopt;
        const auto& before = now.sound.parameters;
        auto player = session.newPlayer(wanted.instrument, wanted.preset,
                                        shared.parameters.valuesAfter(before, wanted.parameters));
        if (!player) {
            session.fail(player.error().message);
            return std::nullopt;
        }
        session.play(wanted, std::move(*player),
                     [&] { shared.parameters.loadChanges(before, wanted.parameters); });
        if (origin == LoadOrigin::stays)
            session.keepOrigin(now.origin);
        number = session.number();
    }
    shared.reporter.reportSound();
    return number;
}

} // namespace idiophone
