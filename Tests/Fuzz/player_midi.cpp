// Fuzzes a player with MIDI from a host: channel and system exclusive messages of any bytes, in
// blocks of any length.
//
// Input: a byte that chooses what keys do and how blocks begin, then messages. Before each message
// a byte gives its distance to the previous one in units of 4 samples.
#include "Fuzz/FuzzTarget.h"
#include "Instrument/Player.h"
#include "Object/ModalObjectFile.h"
#include "Plugin/BlockPieces.h"
#include "Plugin/ObjectEmbedding.h"
#include "Plugin/Tuner.h"
#include "Support/SyntheticObject.h"

#include <array>
#include <bitset>
#include <cstdint>
#include <memory>
#include <vector>

namespace idiophone::fuzz {
namespace {

constexpr double rateHz = 24000;
constexpr int longestSamples = 4096; // later messages are ignored
constexpr int samplesAfter = 200;    // after the last message
constexpr int longestSilencingSamples = 24000;

struct Message {
    int sample = 0; // from the start of the stream
    std::string_view bytes;
};

struct Sound {
    std::vector<float> left, right;

    bool operator==(const Sound&) const = default;
};

/// Returns the length of the first message by its status, up to the end of the bytes.
std::size_t messageLength(std::string_view bytes) {
    const auto status = static_cast<unsigned char>(bytes.front());
    if (status == 0xf0)
        return std::min(bytes.find('\xf7'), bytes.size() - 1) + 1;
    const int kind = status & 0xf0;
    const std::size_t length = status >= 0xf0 ? 1 : kind == 0xc0 || kind == 0xd0 ? 2 : 3;
    return std::min(length, bytes.size());
}

std::vector<Message> messagesIn(std::string_view bytes) {
    std::vector<Message> messages;
    int sample = 0;
    while (bytes.size() >= 2) {
        sample += 4 * static_cast<unsigned char>(bytes.front());
        bytes.remove_prefix(1);
        if (sample >= longestSamples)
            break;
        const auto length = messageLength(bytes);
        messages.push_back({sample, bytes.substr(0, length)});
        bytes.remove_prefix(length);
    }
    return messages;
}

/// Returns eight keys of a small object, scaled for each key, so that all code paths of a strike
/// are fast. It rings for a minute or two, so that only dampers can silence it in time.
std::shared_ptr<const Instrument> smallInstrument() {
    const KeyMap map{.kind = KeyMapKind::scaled,
                     .lowestNote = 60,
                     .highestNote = 67,
                     .resizedFrom = 1,
                     .resizedTo = 0,
                     .object = "small",
                     .strikePath = {{-1, -1, 0}, {1, 1, 0}}};
    auto object = test::syntheticObject({260, 700, 1500, 4000}, {0.2f, 0.2f, 0.2f, 0.2f});
    object.material.damping.fluidPerSecond = 0.1;
    return *buildInstrument(map, {{.name = "small", .modal = encodeModalObject(object)}});
}

ParameterValues valuesOf(unsigned choice) {
    using enum ParameterId;
    ParameterValues values;
    constexpr std::array contacts{strikeContact, scrapeContact, rollContact, bowContact};
    values.set(contact, contacts[choice % 4]);
    values.set(letRing, 0);
    values.set(releaseTime, 0.02);
    values.set(rollCoupling, 50);
    values.set(chatter, (choice & 4) != 0 ? 100 : 0);
    values.set(modalPulse, (choice & 4) != 0 ? 1 : 0);
    values.set(motorDepth, (choice & 4) != 0 ? 60 : 0);
    values.set(mpe, (choice & 8) != 0 ? 1 : 0);
    return values;
}

/// Drives a player as the processor does.
class Host {
public:
    explicit Host(unsigned choice) : values(valuesOf(choice)) { player.prepare(values); }

    /// Plays one block. The messages lie in it, or at its start if it has no samples.
    void play(std::span<const Message> messages, int length, Sound& sound) {
        juce::MidiBuffer midi;
        for (const auto& [at, bytes] : messages) {
            midi.addEvent(bytes.data(), static_cast<int>(bytes.size()), at - sample);
            follow(bytes);
        }
        pieces.begin(midi, length);
        while (const auto piece = pieces.next()) {
            if (!piece->systemExclusive.empty()) {
                tuner.retune(piece->systemExclusive);
                tuner.tune(&player);
            }
            const auto count = static_cast<std::size_t>(piece->length);
            player.process({std::span(left).first(count), std::span(right).first(count)},
                           piece->events, values);
            sound.left.insert(sound.left.end(), left.begin(), left.begin() + piece->length);
            sound.right.insert(sound.right.end(), right.begin(), right.begin() + piece->length);
        }
        sample += length;
    }

    /// Releases every held key, and the pedals that may hold it.
    void releaseAll(Sound& sound) {
        std::vector<std::array<char, 3>> releases{{'\xb0', 64, 0}, {'\xb0', 66, 0}};
        for (std::size_t key = 0; key < keysDown.size(); ++key)
            if (keysDown[key])
                releases.push_back(
                    {static_cast<char>(0x80 | key / 128), static_cast<char>(key % 128), 0});
        std::vector<Message> messages;
        for (const auto& bytes : releases)
            messages.push_back({sample, {bytes.data(), bytes.size()}});
        play(messages, cellSamples, sound);
    }

    bool silent() const { return player.silent(); }

private:
    void follow(std::string_view bytes) {
        if (bytes.size() < 3)
            return;
        const auto at = [&](std::size_t i) { return static_cast<unsigned char>(bytes[i]); };
        const auto key = std::size_t{128} * (at(0) & 0x0f) + (at(1) & 0x7f);
        const int kind = at(0) & 0xf0;
        if (kind == 0x80 || kind == 0x90)
            keysDown[key] = kind == 0x90 && (at(2) & 0x7f) > 0;
    }

    static const std::shared_ptr<const Instrument>& instrument() {
        static const auto built = smallInstrument();
        return built;
    }

    ParameterValues values;
    BlockPieces pieces;
    Tuner tuner;
    Player player{instrument(), rateHz};
    std::bitset<16 * 128> keysDown;
    std::array<float, BlockPieces::maximumSamples> left{}, right{};
    int sample = 0; // first sample of the next block
};

void claimFinite(const Sound& sound) {
    fuzz::claimFinite(sound.left, "what is played is finite");
    fuzz::claimFinite(sound.right, "what is played is finite");
}

/// Plays blocks of these lengths in turn. A block without samples gets the messages of the next
/// block's first sample.
Sound played(std::span<const Message> messages, unsigned choice, std::span<const int> lengths) {
    Host host(choice);
    Sound sound;
    std::size_t next = 0;
    const int end =
        std::min(longestSamples, samplesAfter + (messages.empty() ? 0 : messages.back().sample));
    for (int start = 0, block = 0; start < end; ++block) {
        const int length =
            std::min(lengths[static_cast<std::size_t>(block) % lengths.size()], end - start);
        const auto first = next;
        while (next < messages.size() && messages[next].sample < start + std::max(length, 1))
            ++next;
        host.play(messages.subspan(first, next - first), length, sound);
        start += length;
    }
    claimFinite(sound);

    Sound tail;
    host.releaseAll(tail);
    while (!host.silent() && tail.left.size() < std::size_t{longestSilencingSamples})
        host.play({}, 4 * cellSamples, tail);
    claim(host.silent(), "all is silent when all keys and pedals are up");
    claimFinite(tail);
    return sound;
}

} // namespace

void examine(std::string_view bytes) {
    if (bytes.empty())
        return;
    const auto choice = static_cast<unsigned char>(bytes.front());
    const auto messages = messagesIn(bytes.substr(1));
    std::array lengths{1, 333, 0, 64, 100, 2048, 0, 31};
    std::ranges::rotate(lengths, lengths.begin() + choice / 16 % 8);
    const auto sound = played(messages, choice, lengths);
    claim(sound == played(messages, choice, std::array{512}),
          "blocks of other lengths give the same sound");
}

} // namespace idiophone::fuzz
