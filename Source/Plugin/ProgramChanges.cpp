#include "Plugin/ProgramChanges.h"

namespace idiophone {

juce::MidiBufferIterator ProgramChanges::behindLast(const juce::MidiBuffer& midi) const noexcept {
    auto behind = midi.begin();
    for (auto message = midi.begin(); message != midi.end();) {
        const auto metadata = *message;
        ++message;
        if (keys.isProgramChange(std::span(metadata.data, std::size_t(metadata.numBytes))))
            behind = message;
    }
    return behind;
}

void ProgramChanges::keepMoment(const HostParameters& parameters,
                                std::uint32_t soundChanges) noexcept {
    atLastChange.soundChanges = soundChanges;
    atLastChange.moves = parameters.moves();
    atLastChange.values = parameters.values();
}

void ProgramChanges::follow(std::span<const MidiEvent> events) noexcept {
    keys.follow(events);
    const auto program = keys.takeProgram();
    if (!program)
        return;
    unanswered = programsOfMidi * ++requests + *program;
    atLastChange.request = unanswered;
    moments.next() = atLastChange;
    moments.publish(); // before the request is visible
    requested = unanswered;
}

std::span<const MidiEvent> ProgramChanges::takeKeys(const Player* next) noexcept {
    const bool isAnswer = next != nullptr && next->label() == unanswered;
    if (!isAnswer && refused != unanswered)
        return {};
    const auto held = keys.take();
    return isAnswer ? held : std::span<const MidiEvent>(); // otherwise they have sounded already
}

void ProgramChanges::prepare() noexcept {
    forgetKeys();
    if (requested == none)
        keys.take();
}

const ProgramChanges::Moment* ProgramChanges::momentOf(Request request) noexcept {
    if (const auto* taken = moments.take())
        newest = *taken;
    return request != none && newest.request == request ? &newest : nullptr;
}

void ProgramChanges::end(Request request, bool isAnswered) noexcept {
    if (!isAnswered)
        refused = request;
    requested.compare_exchange_strong(request, none);
}

void ProgramChanges::cancel() noexcept {
    if (const auto request = requested.exchange(none); request != none)
        refused = request;
}

} // namespace idiophone
