// How the mallet of one key differs from the one that is chosen.
#pragma once

namespace idiophone {

struct KeyMallet {
    /// Its size: mass × scale³, radius × scale, so contact time × scale and impulse × scale³.
    double scale = 1;
    /// The key's frequency over that of the middle of its keyboard, for "mallet follows keys".
    double pitchRatio = 1;
};

} // namespace idiophone
