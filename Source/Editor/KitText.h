// Texts about the parts of a kit.
#pragma once

#include "Editor/KitView.h"
#include "Editor/ModeText.h"
#include "Editor/Utf8.h"
#include "Parameters/ParameterTable.h"

#include <juce_core/juce_core.h>

namespace idiophone {

inline InstrumentView::KeyRange keysOf(const KitView::Part& part) {
    return {.lowest = part.lowestNote, .highest = part.highestNote};
}

/// "1–127".
inline juce::String velocitiesText(const KitView::Part& part) {
    return juce::String(part.lowestVelocity) + fromUtf8("\xe2\x80\x93") + // –
           juce::String(part.highestVelocity);
}

inline juce::String levelText(double levelDb) {
    return juce::String(levelDb, 1) + " dB";
}

/// Empty for no group.
inline juce::String chokeText(int group) {
    return group > 0 ? juce::String(group) : juce::String();
}

/// The name of a part's own material or mallet.
inline juce::String choiceText(ParameterId parameter, int choice) {
    return fromUtf8(formatParameter(parameterInfo(parameter), choice));
}

/// "Padauk, Medium rubber": a part's own material and mallet, if it has any.
inline juce::String ownText(const KitView::Part& part) {
    juce::StringArray own;
    if (part.material)
        own.add(choiceText(ParameterId::material, *part.material));
    if (part.mallet)
        own.add(choiceText(ParameterId::mallet, *part.mallet));
    return own.joinIntoString(", ");
}

/// The whole part, for the screen reader.
inline juce::String partText(const KitView::Part& part) {
    juce::StringArray texts{fromUtf8(part.object), "keys " + keysText(keysOf(part)),
                            "velocities " + velocitiesText(part), levelText(part.levelDb)};
    if (part.chokeGroup > 0)
        texts.add("choke group " + chokeText(part.chokeGroup));
    if (const auto own = ownText(part); own.isNotEmpty())
        texts.add(own);
    return texts.joinIntoString(", ");
}

} // namespace idiophone
