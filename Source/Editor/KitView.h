// The window's view of a kit: its parts, and how to change them.
#pragma once

#include "Object/Result.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace idiophone {

/// For the message thread. Parts are indices into `kitParts`; those that do not exist are ignored.
/// Each change is one step of undo and crossfades without a click. The status says why a change
/// was refused.
class KitView {
public:
    static constexpr int chokeGroups = 16, outputs = 8;
    static constexpr double maximumLevelDb = 40;

    /// An object, or a keyboard of them, on some keys and velocities.
    struct Part {
        std::string object; ///< its name: "Cowbell", "Marimba"
        int lowestNote = 0, highestNote = 127;
        int lowestVelocity = 1, highestVelocity = 127;
        double levelDb = 0; ///< ± `maximumLevelDb`
        /// 1 to `chokeGroups`: a strike on one key of the group damps the group's other keys. 0:
        /// none.
        int chokeGroup = 0;
        int output = 0; ///< 1 to `outputs` where a host takes several; 0: one after the other
        /// Choices of ParameterId::material, but not the custom one, and of ParameterId::mallet.
        /// Nothing: those of the sound.
        std::optional<int> material = {}, mallet = {};

        bool operator==(const Part&) const = default;
    };

    virtual ~KitView() = default;

    /// Empty if the sound is no kit.
    virtual std::vector<Part> kitParts() const = 0;
    /// The error says why the sound can be no kit, as a clause: "the keys play a scene".
    virtual Result<void> canBeKit() const = 0;
    /// Makes the sound a kit of one part, which sounds as before.
    virtual void makeKit() = 0;
    /// Changes the part, but not its object. Figures out of range are clamped. More than two parts
    /// on a key at one velocity are refused.
    virtual void changePart(std::size_t part, const Part& wanted) = 0;
    /// The last part stays.
    virtual void removePart(std::size_t part) = 0;
};

} // namespace idiophone
