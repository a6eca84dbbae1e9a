#include "Plugin/Handoff.h"

#include <catch2/catch_test_macros.hpp>
#include <functional>
#include <random>
#include <thread>
#include <utility>

using namespace idiophone;

namespace {

std::atomic<int> alive{0};
std::atomic<bool> destroyedOnAudioThread{false};
thread_local bool isAudioThread = false;
std::function<void()> whileDestroying; ///< stands for the audio thread meanwhile

struct Built {
    explicit Built(int made) : number(made) { ++alive; }
    ~Built() {
        --alive;
        if (isAudioThread)
            destroyedOnAudioThread = true;
        if (whileDestroying)
            whileDestroying();
    }
    int number;
};

} // namespace

TEST_CASE("The newest published object is taken once") {
    Handoff<Built> handoff;
    CHECK(handoff.take() == nullptr);
    handoff.publish(std::make_unique<Built>(1));
    handoff.publish(std::make_unique<Built>(2));
    CHECK(alive == 1);
    const std::unique_ptr<Built> taken(handoff.take());
    REQUIRE(taken != nullptr);
    CHECK(taken->number == 2);
    CHECK(handoff.take() == nullptr);
}

TEST_CASE("Retired objects are destroyed by collect, by publish and at the end") {
    {
        Handoff<Built> handoff;
        handoff.retire(new Built(1));
        CHECK(alive == 1);
        handoff.collect();
        CHECK(alive == 0);
        handoff.retire(new Built(2));
        handoff.retire(new Built(3));
        handoff.publish(std::make_unique<Built>(4));
        CHECK(alive == 1);
        handoff.retire(handoff.take());
    }
    CHECK(alive == 0);
}

TEST_CASE(
    "The queue has room for every object, also for those given back while others are destroyed") {
    std::mt19937 random(1);
    {
        Handoff<Built> handoff;
        Built* current = nullptr;
        Built* fading = nullptr;
        const auto play = [&] { // a few steps of PlayerCrossfade
            for (auto steps = random() % 6; steps > 0; --steps) {
                if (random() % 2 == 0) {
                    handoff.retire(std::exchange(fading, nullptr));
                } else if (Built* const next = handoff.take()) {
                    Built* const previous = std::exchange(current, next);
                    if (fading == nullptr)
                        fading = previous;
                    else
                        handoff.retire(previous);
                }
            }
        };
        whileDestroying = play;
        for (int i = 0; i < 100000; ++i) {
            handoff.publish(std::make_unique<Built>(i));
            play();
            if (random() % 2 == 0)
                handoff.collect();
        }
        whileDestroying = nullptr;
        handoff.retire(fading);
        handoff.retire(current);
    }
    CHECK(alive == 0);
}

TEST_CASE("In many hand-offs nothing is lost, leaked or destroyed on the audio thread") {
    constexpr int rounds = 200000;
    int lastTaken = 0;
    bool inOrder = true;
    {
        Handoff<Built> handoff;
        std::atomic<bool> stop{false};
        std::thread audio([&] {
            isAudioThread = true;
            Built* current = nullptr;
            Built* fading = nullptr;
            while (!stop || lastTaken < rounds) {
                if (Built* next = handoff.take()) {
                    inOrder = inOrder && next->number > lastTaken;
                    lastTaken = next->number;
                    handoff.retire(std::exchange(fading, std::exchange(current, next)));
                }
            }
            handoff.retire(fading);
            handoff.retire(current);
        });
        for (int i = 1; i <= rounds; ++i)
            handoff.publish(std::make_unique<Built>(i));
        stop = true;
        audio.join();
    }
    CHECK(inOrder);
    CHECK(lastTaken == rounds);
    CHECK(alive == 0);
    CHECK_FALSE(destroyedOnAudioThread);
}
