// Follows a CLAP host that modulates parameters, of all notes or of single ones.
#pragma once

#include "Instrument/NoteShifts.h"
#include "Plugin/ClapNotes.h"
#include "Plugin/HostParameters.h"

#include <array>
#include <bitset>
#include <clap/events.h>
#include <optional>

namespace idiophone {

/// For the audio thread; neither allocates, locks nor throws. The parameters must outlive it.
class ClapModulation {
public:
    explicit ClapModulation(const HostParameters& hostParameters) : parameters(hostParameters) {}

    /// Amounts are shares of the range on the parameter's own scale. Those of single notes replace
    /// those of all, and reach the newest note of each key that `notes` knows.
    void follow(const clap_event_param_mod& event,
                HostParameter& parameter,
                const ClapNotes& notes) noexcept;
    /// Forgets the amounts of a key, on which a new note begins.
    void beginNote(int key) noexcept { amounts[static_cast<std::size_t>(key)] = {}; }
    /// Brings the shifts up to date for the next block, and forgets notes that have ended.
    void apply(const ClapNotes& notes, NoteShifts& shifts) noexcept;
    /// Forgets all notes.
    void reset() noexcept { amounts = {}; }

private:
    using Amounts = std::array<std::optional<double>, noteTargetCount>;

    NoteShifts::Shares sharesOf(const Amounts& ofNote) const noexcept;

    const HostParameters& parameters;
    std::array<Amounts, 128> amounts{}; ///< [keys]
    std::bitset<128> moved;             ///< keys whose shifts are out of date or may become so
};

} // namespace idiophone
