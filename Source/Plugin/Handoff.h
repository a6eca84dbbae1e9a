// Hands an object built elsewhere to the audio thread, and takes back objects that the audio thread
// no longer needs, for destruction elsewhere. Neither side waits.
#pragma once

#include <atomic>
#include <boost/lockfree/spsc_queue.hpp>
#include <memory>

namespace idiophone {

/// [message side] is any thread except the audio thread, one at a time: the caller serialises.
/// [audio thread] runs the callback; it may hold two `Built`s at a time.
template <class Built>
class Handoff {
public:
    Handoff() = default;
    Handoff(const Handoff&) = delete;
    Handoff& operator=(const Handoff&) = delete;

    /// [message side] Call after the last callback.
    ~Handoff() {
        delete pending.load();
        collect();
    }

    /// [message side] Publishes an object for the next `take`. Destroys the one published before if
    /// it was not taken, and everything given back.
    void publish(std::unique_ptr<Built> built) {
        collect();
        delete pending.exchange(built.release());
    }

    /// [message side] Destroys the objects that the audio thread gave back.
    void collect() {
        retired.consume_all([](Built* built) { delete built; });
    }

    /// [audio thread] Returns the newest published object, now owned by the audio thread, or
    /// nullptr.
    Built* take() noexcept { return pending.exchange(nullptr); }

    /// [audio thread] Gives an object back for destruction; ignores nullptr.
    void retire(Built* built) noexcept {
        // The queue is never full. When `collect` begins, the audio thread has at most three
        // objects: two held and one pending. At most one more is published before the next
        // `collect`. So at most four come back until `collect` has freed their places.
        if (built != nullptr)
            retired.push(built);
    }

private:
    std::atomic<Built*> pending{nullptr};
    boost::lockfree::spsc_queue<Built*, boost::lockfree::capacity<4>> retired;
    static_assert(std::atomic<Built*>::is_always_lock_free);
};

} // namespace idiophone
