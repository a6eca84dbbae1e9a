#include "Plugin/ClapModulation.h"

#include <algorithm>

namespace idiophone {

void ClapModulation::follow(const clap_event_param_mod& event,
                            HostParameter& parameter,
                            const ClapNotes& notes) noexcept {
    if (event.note_id < 0 && event.channel < 0 && event.key < 0)
        return parameter.setModulation(event.amount);
    if (const auto target = noteTargetIndex(parameter.info().parameter))
        notes.forAddressed(event, [&](int key) {
            const auto index = static_cast<std::size_t>(key);
            amounts[index][*target] = event.amount;
            moved[index] = true;
        });
}

void ClapModulation::apply(const ClapNotes& notes, NoteShifts& shifts) noexcept {
    for (std::size_t index = 0; index < moved.size(); ++index) {
        if (!moved[index])
            continue;
        const auto key = static_cast<int>(index);
        auto& ofKey = amounts[index];
        if (!notes.has(key))
            ofKey = {};
        shifts.set(key, sharesOf(ofKey));
        moved[index] =
            std::ranges::any_of(ofKey, [](const auto& amount) { return amount.has_value(); });
    }
}

/// A note's own amount replaces that of all notes, which the parameter already has.
NoteShifts::Shares ClapModulation::sharesOf(const Amounts& ofNote) const noexcept {
    NoteShifts::Shares shares{};
    for (std::size_t i = 0; i < shares.size(); ++i)
        if (const auto amount = ofNote[i]) {
            const auto& parameter = parameters[noteTargets()[i]];
            shares[i] = parameter.normalisedWith(*amount) - parameter.modulatedNormalised();
        }
    return shares;
}

} // namespace idiophone
