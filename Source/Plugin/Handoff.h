// Hands something that was built elsewhere to the audio thread, and takes back what the audio
// thread no longer needs, so that it is destroyed elsewhere too. Nothing waits for anybody.
#pragma once

#include <array>
#include <atomic>
#include <memory>

namespace idiophone {

/// [message side] is any thread but the audio thread, one at a time: the caller serialises.
/// [audio thread] is the one that runs the callback; it may hold two `Built`s at a time.
template <class Built>
class Handoff {
public:
    Handoff() = default;
    Handoff(const Handoff&) = delete;
    Handoff& operator=(const Handoff&) = delete;

    /// [message side] after the last callback.
    ~Handoff() {
        delete pending.load();
        collect();
    }

    /// [message side] The next `take` gets this. What was published before and not yet taken is
    /// destroyed, and so is what came back.
    void publish(std::unique_ptr<Built> built) {
        collect();
        delete pending.exchange(built.release());
    }

    /// [message side] Destroys what the audio thread gave back.
    void collect() {
        for (auto& slot : retired)
            delete slot.exchange(nullptr);
    }

    /// [audio thread] The newest that was published, which the audio thread now owns, or nullptr.
    Built* take() noexcept { return pending.exchange(nullptr); }

    /// [audio thread] Gives one back for destruction; nullptr is nothing to give back.
    void retire(Built* built) noexcept {
        if (built == nullptr)
            return;
        for (auto& slot : retired) {
            Built* empty = nullptr;
            if (slot.compare_exchange_strong(empty, built))
                return;
        }
        // Not reached: every `publish` empties the slots, and from one to the next no more than
        // the two that the audio thread held and the two that may have been pending come back.
    }

private:
    std::atomic<Built*> pending{nullptr};
    std::array<std::atomic<Built*>, 4> retired{};
    static_assert(std::atomic<Built*>::is_always_lock_free);
};

} // namespace idiophone
