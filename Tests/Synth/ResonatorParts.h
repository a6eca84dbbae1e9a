// The parts of a resonator, built one after another for tests of each alone.
#pragma once

#include "ModalReference.h"
#include "Synth/ContactSet.h"
#include "Synth/ForceResponses.h"

#include <memory>
#include <vector>

namespace idiophone::test {

/// A bank whose modes follow the law of the object's own material.
struct ResonatorParts {
    static constexpr double sampleRateHz = 48000;

    explicit ResonatorParts(ModalObject ofObject)
        : object(std::move(ofObject)), scratch(object.modeCount(), 1),
          bank(object.modeCount(), 1, sampleRateHz), output(bank, {}, sampleRateHz, scratch),
          groups(object,
                 std::make_shared<const std::vector<double>>(summedSquareShapes(object)),
                 0,
                 sampleRateHz,
                 scratch),
          residues(object, groups, bank, 1, scratch), active(bank, output, scratch) {
        groups.set({.law = {.damping = object.material.damping}, .compression = 0});
        groups.follow();
        movePoles();
        active.setTau(1e-6);
    }

    void movePoles() {
        bank.movePoles(groups.eigenvalues(), groups.conditions().law, 20, 23000, groups.dampings(),
                       groups.silences());
    }

    /// Lets all modes ring with their index plus 1 as amplitude.
    void ring() {
        for (std::size_t g = 0; g < bank.size(); ++g)
            bank.setState(g, {1.0 + static_cast<double>(g), 0});
        active.listRinging();
        active.survey(ActiveModes::Change::any);
    }

    ModalObject object;
    SynthesisScratch scratch;
    ModalBank bank;
    BankOutput output;
    ModeGroups groups;
    GroupResidues residues;
    ActiveModes active;
};

} // namespace idiophone::test
