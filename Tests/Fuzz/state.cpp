// What a host hands back to the plugin when a project opens.
#include "Plugin/State.h"
#include "Fuzz/FuzzTarget.h"

void idiophone::fuzz::examine(std::string_view bytes) {
    auto state = parseState(bytes);
    if (!state)
        return claimSentence(state.error());
    for (const auto& info : parameterTable()) {
        const double value = state->parameters[info.parameter];
        claim(value == info.clamped(value), "parameters have values that they can take");
        const int controller = state->controllers[info.parameter];
        claim(controller == noController || isLearnable(controller), "controllers can be learned");
    }
    for (const auto& object : state->objects)
        claim(!object.modal.empty(), "objects have bytes");
    state->preset.unknownParameters.clear(); // which are not written
    const auto written = encodeState(*state);
    const auto again = parseState(written);
    claim(again && *again == *state, "a state that was written reads back equal");
    claim(encodeState(*again) == written, "an equal state is written as the same bytes");
}
