// How strongly each slot is damped: by released keys, pressure, mallets that stay after a dead
// stroke, strikes on others of its choke group, and All Sound Off.
#pragma once

#include "Instrument/Instrument.h"
#include "Instrument/KeyState.h"
#include "Parameters/ParameterTable.h"
#include "Synth/Synthesiser.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace idiophone {

/// Constructed off the audio thread; the rest is for the audio thread and neither allocates, locks
/// nor throws. The instrument must outlive it.
class Dampers {
public:
    /// [s] Time in which an object falls by 60 dB under a mallet that stays.
    static constexpr double deadStrokeSeconds = 0.1;
    /// [s] The same for a hand that grips a choked object.
    static constexpr double chokingSeconds = 0.06;

    /// Without mallets, on a stage, nothing but All Sound Off damps.
    Dampers(const Instrument& instrument, std::size_t slots, bool hasMallets);

    /// Sets whether a hand touches a slot, and so holds it as a key does.
    void touch(std::size_t slot, bool isTouched) { damped[slot].isTouched = isTouched; }
    void liftHands();
    /// A key or hand strikes the slot, or begins a contact. The mallet of a dead stroke stays.
    void strike(std::size_t slot, const ParameterValues& values);
    /// Damps the slots of a choke group until they are struck again.
    void choke(int group);
    /// A key of the slot is released. Velocities above 64 damp faster, at 127 ten times as fast.
    void release(std::size_t slot, int velocity);
    /// Sets the slot's own release time in seconds; nothing: the parameter's.
    void setReleaseTime(std::size_t slot, std::optional<double> seconds) {
        damped[slot].releaseSeconds = seconds;
    }

    /// Sends the damping of every slot to the synthesiser where it has changed. The two slots are
    /// held as by a key.
    void update(const ParameterValues& values,
                const KeyState& keys,
                std::optional<std::size_t> heldByHand,
                std::optional<std::size_t> heldByInput,
                bool isSilenced,
                Synthesiser& synthesiser);
    void reset(); ///< lifts mallets, forgets velocities; hands stay

private:
    struct Slot {
        bool isTouched = false, isHeld = false;
        bool isDead = false, isChoked = false;
        float pressure = 0;                     ///< maximum of its keys
        double quickness = 1;                   ///< by the release velocity
        std::optional<double> releaseSeconds{}; ///< its own
        double dampingPerSecond = 0;            ///< set last
    };

    void followKeys(const KeyState& keys, bool pressureDamps);

    const Instrument& instrument;
    bool hasMallets;
    std::vector<Slot> damped; ///< [slots]
};

} // namespace idiophone
