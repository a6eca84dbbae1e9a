// Plays a sound that was made from the loaded one.
#pragma once

#include "Plugin/SoundSession.h"

#include <optional>

namespace idiophone {

/// The next SoundSession::origin. New: the number of the new load. If it stays, jobs that began
/// with the loaded sound go on, as during edits of a kit.
enum class LoadOrigin { isNew, stays };

/// Plays the wanted sound instead of the loaded one, and changes only the parameters that differ
/// between the two. Returns the number of the load. Returns nothing if the loaded sound no longer
/// plays, or if memory does not suffice, which it reports. For the message thread.
std::optional<int> playInstead(SharedParts& shared,
                               SoundSession& session,
                               const SoundSession::Loaded& now,
                               const Sound& wanted,
                               LoadOrigin origin);

} // namespace idiophone
