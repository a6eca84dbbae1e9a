// How the mallet of one key differs from the chosen mallet.
#pragma once

namespace idiophone {

struct KeyMallet {
    /// The mallet's size: mass × scale³, radius × scale, so contact time × scale and impulse ×
    /// scale³.
    double scale = 1;
    /// The key's frequency over that of the middle of its keyboard, for "mallet follows keys".
    double pitchRatio = 1;
    /// Factor of its impulses and forces: the keyboard's voicing.
    double gain = 1;
};

/// Returns the factor of the force that scrapes or rolls a key. A contact s times as large has s²
/// the area.
inline double forceScale(const KeyMallet& mallet) noexcept {
    return mallet.gain * mallet.scale * mallet.scale;
}

} // namespace idiophone
