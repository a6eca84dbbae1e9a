// Bounds how long the loaded sound rings on, for the host.
#pragma once

#include "Instrument/DecayBounds.h"
#include "Plugin/EngineReport.h"

#include <array>
#include <atomic>
#include <bit>
#include <memory>

namespace idiophone {

class TailLength {
public:
    static constexpr double maximumSeconds = 120;

    /// [session] Call when another instrument is loaded, or when the tuning changes.
    void setInstrument(std::shared_ptr<const Instrument> instrument);
    void setTuning(const KeyTuning& keys) noexcept;

    /// [any thread] Returns the time that a stage's bodies move, plus the decay of the lowest mode
    /// by 96 dB (one 16-bit step), plus the decay of the room by 96 dB. Takes the mode as low as
    /// wheels may bend it. At most `maximumSeconds`: lightly damped objects ring for minutes, and
    /// hosts would render as long. Ignores dampers, whatever `let_ring` is: pedals hold released
    /// keys, and many hosts ask only once.
    double seconds(const ParameterValues& values, const EngineReport& report) const noexcept;

private:
    /// Each double is read whole. A reader during a write may see a mix of old and new ones, and
    /// the host asks again.
    class SharedBounds {
    public:
        SharedBounds() { store({}); }
        void store(const DecayBounds& bounds) noexcept;
        DecayBounds load() const noexcept;

    private:
        using Values = std::array<double, sizeof(DecayBounds) / sizeof(double)>;
        std::array<std::atomic<double>, std::tuple_size_v<Values>> shared;
    };

    void followTuning() noexcept;

    SharedBounds ownKeys, allKeys; ///< RingingKeys
    std::atomic<double> semitonesBelowEqual{0}, stageSeconds{0};

    // Owned by the session.
    std::shared_ptr<const Instrument> instrument;
    KeyTuning tuning;
};

} // namespace idiophone
