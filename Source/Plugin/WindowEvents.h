// Hands notes, strikes and drags of the window to the audio thread.
#pragma once

#include "Instrument/Player.h"

#include <atomic>
#include <bitset>
#include <boost/lockfree/spsc_queue.hpp>
#include <cstdint>
#include <variant>

namespace idiophone {

/// A key of the on-screen keyboard, or a hand on an object of the picture.
struct WindowEvent {
    std::uint64_t instrument = 0; ///< serial number of the struck or touched instrument
    std::variant<MidiEvent, SurfaceStrike, SurfaceTouch> played;

    /// Returns whether the event releases a key or lifts a hand.
    bool releases() const noexcept;
};

class WindowEvents {
public:
    static constexpr std::size_t capacity = 256;
    /// Maximum number of notes of one `read`: the queue, All Sound Off and a release of every key.
    static constexpr std::size_t maximumNotes = capacity + 129;

    /// [message thread] If the queue is full, drops the event and returns false. If it drops a
    /// release, the next `read` releases all keys and lifts all hands.
    bool push(const WindowEvent& event) noexcept;
    /// [message thread] Queues a note; velocity 0 releases it.
    bool pushNote(int note, int velocity) noexcept;
    /// [message thread] The next `read` ends all sound at once, behind what is queued.
    void silence() noexcept { silenceAsked = true; }

    /// [audio thread] Hands each pending note to `takeNote`, oldest first, and passes strikes and
    /// drags to the player of their instrument. Drops those for another instrument or without a
    /// player. Neither allocates, locks nor throws.
    template <class TakeNote>
    void read(Player* player, TakeNote&& takeNote) noexcept {
        queue.consume_all([&](const WindowEvent& event) {
            if (const auto* note = std::get_if<MidiEvent>(&event.played)) {
                held.set(note->bytes[1], note->isNoteOn());
                takeNote(*note);
            } else if (player != nullptr) {
                playHand(event, *player);
            }
        });
        if (silenceAsked.exchange(false)) {
            takeNote(allSoundOff);
            held.reset();
            if (player != nullptr)
                player->liftHands();
        }
        if (!releaseLost.exchange(false))
            return;
        for (std::size_t note = 0; note < held.size(); ++note)
            if (held.test(note))
                takeNote(noteEvent(static_cast<int>(note), 0));
        held.reset();
        if (player != nullptr)
            player->liftHands();
    }

    /// [audio thread] Discards all pending events; call when all keys are up and hands lifted.
    void clear() noexcept;

private:
    static const MidiEvent allSoundOff;
    static MidiEvent noteEvent(int note, int velocity) noexcept;
    static void playHand(const WindowEvent& event, Player& player) noexcept;

    boost::lockfree::spsc_queue<WindowEvent, boost::lockfree::capacity<capacity>> queue;
    std::atomic<bool> releaseLost{false}; ///< because the queue was full
    std::atomic<bool> silenceAsked{false};
    std::bitset<128> held; ///< the audio thread's
};

} // namespace idiophone
