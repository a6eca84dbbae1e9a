#include "Instrument/MidiTuning.h"

#include <algorithm>
#include <iterator>

namespace idiophone {
namespace {

using Bytes = std::span<const std::uint8_t>;

enum class Content { allKeys, namedKeys, octaveOfOneByte, octaveOfTwoBytes };

struct Kind {
    std::uint8_t subId = 0; ///< the second one
    Content content{};
    std::size_t begin = 0; ///< where the pitches begin, behind program, bank, name, channels
};

constexpr Kind kinds[] = {
    {0x01, Content::allKeys, 22},         {0x04, Content::allKeys, 23},
    {0x02, Content::namedKeys, 7},        {0x07, Content::namedKeys, 8},
    {0x05, Content::octaveOfOneByte, 23}, {0x06, Content::octaveOfTwoBytes, 23},
    {0x08, Content::octaveOfOneByte, 8},  {0x09, Content::octaveOfTwoBytes, 8}};

/// Returns nullptr if the message is not for tuning.
const Kind* kindOf(Bytes message) noexcept {
    // F0, non-real or real time, any device, MIDI Tuning Standard.
    if (message.size() < 5 || (message[1] != 0x7e && message[1] != 0x7f) || message[3] != 0x08)
        return nullptr;
    const auto* kind = std::ranges::find(kinds, message[4], &Kind::subId);
    return kind == std::end(kinds) ? nullptr : kind;
}

bool isData(Bytes bytes) noexcept {
    return std::ranges::all_of(bytes, [](std::uint8_t byte) { return byte < 0x80; });
}

} // namespace

bool MidiTuning::isFor(Bytes message) noexcept {
    return kindOf(message) != nullptr;
}

bool MidiTuning::read(Bytes message) noexcept {
    const auto* kind = kindOf(message);
    if (kind == nullptr)
        return false;
    const auto content = message.subspan(std::min(kind->begin, message.size()));
    switch (kind->content) {
    case Content::allKeys:
        readKeys(content);
        break;
    case Content::namedKeys:
        readNamedKeys(content);
        break;
    case Content::octaveOfOneByte:
        readOctave(content, 1);
        break;
    case Content::octaveOfTwoBytes:
        readOctave(content, 2);
        break;
    }
    return true;
}

void MidiTuning::readKeys(Bytes pitches) noexcept {
    for (std::size_t key = 0; key < KeyTuning::notes && pitches.size() >= 3; ++key) {
        readKey(key, pitches.first(3));
        pitches = pitches.subspan(3);
    }
}

void MidiTuning::readNamedKeys(Bytes changes) noexcept {
    for (; changes.size() >= 4; changes = changes.subspan(4))
        readKey(changes.front(), changes.subspan(1, 3));
}

/// The pitch is a note of equal temperament and 14 bits of a semitone above; 7F 7F 7F is no change.
void MidiTuning::readKey(std::size_t key, Bytes pitch) noexcept {
    const bool isChange =
        std::ranges::any_of(pitch, [](std::uint8_t byte) { return byte != 0x7f; });
    if (key < KeyTuning::notes && isChange && isData(pitch))
        tuning.semitonesFromEqual[key] =
            pitch[0] + ((pitch[1] << 7) + pitch[2]) / 16384.0 - static_cast<double>(key);
}

/// An offset of one byte is in cents from 64; one of two bytes divides the semitones from −1 to 1.
void MidiTuning::readOctave(Bytes offsets, std::size_t bytesOfNote) noexcept {
    for (std::size_t note = 0; note < 12 && offsets.size() >= bytesOfNote; ++note) {
        const auto offset = offsets.first(bytesOfNote);
        offsets = offsets.subspan(bytesOfNote);
        if (!isData(offset))
            continue;
        const double semitones = bytesOfNote == 1 ? (offset[0] - 64) / 100.0
                                                  : ((offset[0] << 7) + offset[1] - 8192) / 8192.0;
        for (std::size_t key = note; key < KeyTuning::notes; key += 12)
            tuning.semitonesFromEqual[key] = semitones;
    }
}

} // namespace idiophone
