// How the mallet of one key differs from the one that is chosen.
#pragma once

namespace idiophone {

struct KeyMallet {
    /// Its size: mass × scale³, radius × scale, so contact time × scale and impulse × scale³.
    double scale = 1;
    /// The key's frequency over that of the middle of its keyboard, for "mallet follows keys".
    double pitchRatio = 1;
    /// By which its impulses and forces are multiplied: the keyboard's voicing.
    double gain = 1;
};

/// The factor of the force with which a key is scraped or rolled. A larger contact has s² the area.
inline double forceScale(const KeyMallet& mallet) noexcept {
    return mallet.gain * mallet.scale * mallet.scale;
}

} // namespace idiophone
