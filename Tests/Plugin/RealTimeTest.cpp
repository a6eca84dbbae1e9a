// The audio callback does not allocate, lock or call the system, except that a stage may wake its
// worker. Other tests here prove that the trap catches each of these.
#include "Plugin/WatchedHost.h"

#include <catch2/catch_test_macros.hpp>
#include <cstdlib>
#include <functional>
#include <mutex>
#include <random>
#include <shared_mutex>
#include <thread>

// Declare the functions that the trap watches. Other systems lack some of them.
#if defined(__linux__) && defined(__GLIBC__)
#include <fcntl.h>
#include <linux/futex.h>
#include <pthread.h>
#include <semaphore.h>
#include <sys/syscall.h>
#include <unistd.h>
#endif

using namespace idiophone;
using namespace idiophone::test;

// The faults are calls of Linux, where alone the trap works.
#if defined(__linux__) && defined(__GLIBC__)

namespace {

/// Runs a callback with a planted fault.
template <class Fault>
RealTimeFaults plantedIn(Processor& processor, Fault&& fault) {
    juce::AudioBuffer<float> buffer(2, 256);
    juce::MidiBuffer midi = testMusic(256, 64);
    return faultsOf([&] {
        processor.processBlock(buffer, midi);
        fault();
    });
}

void hide(const void* pointer) { // from the optimiser
    asm volatile("" : : "r"(pointer) : "memory");
}

const int* madeWhenFirstAskedFor() {
    static const int made = static_cast<int>(std::random_device()());
    return &made;
}

} // namespace

TEST_CASE("The real-time trap catches every kind of planted fault in a callback") {
    if (!realTimeTrapWorks())
        SKIP("the trap needs Linux with glibc and no sanitizer");
    Processor processor;
    restore(processor, testState());
    processor.prepareToPlay(48000, 256);
    CHECK(plantedIn(processor, [] {}).none());

    CHECK(plantedIn(processor, [] { hide(std::malloc(10)); }).allocations > 0);
    CHECK(plantedIn(processor, [] { hide(new int); }).allocations > 0);
    CHECK(plantedIn(processor, [] { hide(std::aligned_alloc(64, 64)); }).allocations > 0);
    auto* block = new std::vector<float>(100);
    CHECK(plantedIn(processor, [&] { delete block; }).allocations > 0);
    std::vector<int> growing;
    CHECK(plantedIn(processor, [&] { growing.push_back(1); }).allocations > 0);
    CHECK(plantedIn(processor, [] { juce::String(3.25).toStdString(); }).allocations > 0);

    std::mutex mutex;
    CHECK(plantedIn(processor, [&] { const std::scoped_lock lock(mutex); }).locks > 0);
    CHECK(plantedIn(processor, [&] {
              const std::unique_lock lock(mutex, std::try_to_lock);
          }).locks > 0);
    std::shared_mutex readers;
    CHECK(plantedIn(processor, [&] { const std::shared_lock lock(readers); }).locks > 0);
    juce::CriticalSection section;
    CHECK(plantedIn(processor, [&] { const juce::ScopedLock lock(section); }).locks > 0);
    juce::MidiKeyboardState keyboard;
    juce::MidiBuffer midi;
    CHECK(plantedIn(processor, [&] { keyboard.processNextMidiBuffer(midi, 0, 64, true); }).locks >
          0);
    CHECK(plantedIn(processor, [&] { processor.view().status.takeStatus(); }).locks > 0);
}

TEST_CASE("The real-time trap catches and names each waiting call even if it returns at once") {
    if (!realTimeTrapWorks())
        SKIP("the trap needs Linux with glibc and no sanitizer");
    pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER;
    pthread_cond_t condition = PTHREAD_COND_INITIALIZER;
    pthread_rwlock_t lock = PTHREAD_RWLOCK_INITIALIZER;
    pthread_spinlock_t spin;
    REQUIRE(pthread_spin_init(&spin, PTHREAD_PROCESS_PRIVATE) == 0);
    sem_t semaphore;
    REQUIRE(sem_init(&semaphore, 0, 0) == 0);
    pthread_barrier_t barrier;
    REQUIRE(pthread_barrier_init(&barrier, nullptr, 1) == 0);
    pthread_once_t once = PTHREAD_ONCE_INIT;
    constexpr timespec past{};
    constexpr auto clock = CLOCK_MONOTONIC;
    const auto unlock = [&] { pthread_rwlock_unlock(&lock); };
    const std::vector<std::pair<std::string, std::function<void()>>> waits{
        {"pthread_mutex_lock", [&] { pthread_mutex_lock(&mutex); }},
        // Each wait returns at once and leaves the mutex locked.
        {"pthread_cond_timedwait", [&] { pthread_cond_timedwait(&condition, &mutex, &past); }},
        {"pthread_cond_clockwait",
         [&] { pthread_cond_clockwait(&condition, &mutex, clock, &past); }},
        {"pthread_cond_signal", [&] { pthread_cond_signal(&condition); }},
        {"pthread_cond_broadcast", [&] { pthread_cond_broadcast(&condition); }},
        {"pthread_mutex_trylock", [&] { pthread_mutex_trylock(&mutex); }},
        {"pthread_mutex_timedlock", [&] { pthread_mutex_timedlock(&mutex, &past); }},
        {"pthread_mutex_clocklock", [&] { pthread_mutex_clocklock(&mutex, clock, &past); }},
        {"pthread_rwlock_rdlock", [&] { pthread_rwlock_rdlock(&lock), unlock(); }},
        {"pthread_rwlock_wrlock", [&] { pthread_rwlock_wrlock(&lock), unlock(); }},
        {"pthread_rwlock_tryrdlock", [&] { pthread_rwlock_tryrdlock(&lock), unlock(); }},
        {"pthread_rwlock_trywrlock", [&] { pthread_rwlock_trywrlock(&lock), unlock(); }},
        {"pthread_rwlock_timedrdlock", [&] { pthread_rwlock_timedrdlock(&lock, &past), unlock(); }},
        {"pthread_rwlock_timedwrlock", [&] { pthread_rwlock_timedwrlock(&lock, &past), unlock(); }},
        {"pthread_rwlock_clockrdlock",
         [&] { pthread_rwlock_clockrdlock(&lock, clock, &past), unlock(); }},
        {"pthread_rwlock_clockwrlock",
         [&] { pthread_rwlock_clockwrlock(&lock, clock, &past), unlock(); }},
        {"pthread_spin_lock", [&] { pthread_spin_lock(&spin), pthread_spin_unlock(&spin); }},
        {"pthread_spin_trylock", [&] { pthread_spin_trylock(&spin), pthread_spin_unlock(&spin); }},
        {"sem_post", [&] { sem_post(&semaphore); }},
        {"sem_wait", [&] { sem_wait(&semaphore); }},
        {"sem_trywait", [&] { sem_trywait(&semaphore); }},
        {"sem_timedwait", [&] { sem_timedwait(&semaphore, &past); }},
        {"sem_clockwait", [&] { sem_clockwait(&semaphore, clock, &past); }},
        {"pthread_barrier_wait", [&] { pthread_barrier_wait(&barrier); }},
        {"pthread_once", [&] { pthread_once(&once, [] {}); }},
        {"__cxa_guard_acquire", [] { hide(madeWhenFirstAskedFor()); }}};
    for (const auto& [name, wait] : waits) {
        const auto faults = faultsOf(wait);
        INFO(name);
        CHECK(faults.locks >= 1); // a waiting call may call others
        CHECK(faults.first.starts_with(name));
    }
    CHECK(faultsOf([] { hide(madeWhenFirstAskedFor()); }).none()); // already initialised
    pthread_mutex_unlock(&mutex);
    pthread_barrier_destroy(&barrier);
    sem_destroy(&semaphore);
    pthread_spin_destroy(&spin);
}

TEST_CASE("The real-time trap catches planted system calls in a callback") {
    if (!systemCallTrapWorks())
        SKIP("needs Linux 5.11 on x86-64 and no sanitizer");
    Processor processor;
    restore(processor, testState());
    processor.prepareToPlay(48000, 256);
    const auto systemCalls = [&](auto&& fault) { return plantedIn(processor, fault).systemCalls; };
    CHECK(systemCalls([] {}) == 0);
    volatile int parent = 0;
    CHECK(systemCalls([&] { parent = ::getppid(); }) > 0);
    CHECK(systemCalls([] { std::this_thread::sleep_for(std::chrono::microseconds(1)); }) > 0);
    CHECK(systemCalls([] { std::this_thread::yield(); }) > 0);
    CHECK(systemCalls([] { ::close(::open("/dev/null", O_WRONLY)); }) > 0);
    std::atomic<int> number{0};
    CHECK(systemCalls([&] { number.notify_all(); }) == 0); // no thread waits, so no call
    const auto futex = [](int operation) {
        std::uint32_t word = 0;
        ::syscall(SYS_futex, &word, operation, 1, nullptr, nullptr, 0);
    };
    CHECK(systemCalls([&] { futex(FUTEX_WAIT_PRIVATE); }) > 0);
    CHECK(systemCalls([&] { futex(FUTEX_WAKE_PRIVATE); }) == 0);
    CHECK(plantedIn(processor, [&] { futex(FUTEX_WAKE_PRIVATE); }).wakes > 0);
    const auto written = systemCalls([] { ::write(-1, "", 0); });
    CHECK(written > 0);
}

#endif

TEST_CASE("No parameter at either end makes the callback allocate, lock or call the system") {
    if (!realTimeTrapWorks())
        SKIP("the trap needs Linux with glibc and no sanitizer");
    WatchedHost host(256);
    restore(host.processor, testState());
    const auto music = testMusic(256, 40);
    for (auto* parameter : host.processor.getParameters()) {
        host.what = parameter->getName(100).toStdString();
        for (const float end : {0.0f, 1.0f}) {
            // Automation may come on the audio thread.
            CHECK(faultsOf([&] { parameter->setValue(end); }).none());
            for (int block = 0; block < 6; ++block)
                host.block(music, 256);
        }
        parameter->setValue(parameter->getDefaultValue());
    }
    CHECK(host.loudestSample > 0.001f);
}

TEST_CASE("System exclusive tuning messages do not allocate, lock or call the system") {
    if (!realTimeTrapWorks())
        SKIP("the trap needs Linux with glibc and no sanitizer");
    WatchedHost host(256);
    restore(host.processor, testState());
    juce::MidiBuffer midi = testMusic(256, 40);
    const juce::uint8 tuning[] = {0x7f, 0x7f, 0x08, 0x02, 0, 1, lowestTestNote, 61, 64, 0};
    for (int stamp = 0; stamp < 256; stamp += 50)
        midi.addEvent(juce::MidiMessage::createSysExMessage(tuning, sizeof tuning), stamp);
    host.what = "retuned";
    for (int block = 0; block < 10; ++block)
        host.block(midi, 256);
}

TEST_CASE("Learning controllers and moving every parameter with them stays real-time safe") {
    if (!realTimeTrapWorks())
        SKIP("the trap needs Linux with glibc and no sanitizer");
    WatchedHost host(256);
    restore(host.processor, testState());
    auto& learn = host.processor.windowSession().controllers;
    host.what = "learning";
    int learned = 38;
    for (const auto& info : parameterTable()) {
        learn.learnController(info.parameter);
        do
            learned = learned % 119 + 1;
        while (!isMeantToBeLearned(learned));
        juce::MidiBuffer midi;
        midi.addEvent(juce::MidiMessage::controllerEvent(1, learned, 64), 3);
        host.block(midi, 256);
        CHECK(learn.controllerOf(info.parameter));
    }
    host.what = "all moving";
    for (const int value : {0, 127, 64}) {
        juce::MidiBuffer music = testMusic(256, 40);
        for (int number = 1; number < 120; ++number)
            music.addEvent(juce::MidiMessage::controllerEvent(2, number, value), number);
        for (int block = 0; block < 10; ++block)
            host.block(music, 256);
    }
}

TEST_CASE("Crowded, overlong and empty blocks, resets and program changes stay real-time safe") {
    if (!realTimeTrapWorks())
        SKIP("the trap needs Linux with glibc and no sanitizer");
    WatchedHost host(20000);
    juce::MidiBuffer crowded;
    for (int i = 0; i < 20000; ++i)
        crowded.addEvent(juce::MidiMessage::noteOn(1, i % 128, static_cast<juce::uint8>(99)),
                         i / 10000);
    std::vector<juce::uint8> dump(2000, 1);
    crowded.addEvent(juce::MidiMessage::createSysExMessage(dump.data(), 2000), 5);
    crowded.addEvent(juce::MidiMessage::programChange(1, 1), 6);
    crowded.addEvent(juce::MidiMessage::allSoundOff(1), 7);
    for (const int samples : {20000, 1, 0, 7, 8192, 8193})
        for (int round = 0; round < 3; ++round) {
            host.what = std::to_string(samples) + " samples";
            host.processor.view().instrument.playNote(72, 100);
            host.block(crowded, samples);
            host.processor.reset();
            host.block(crowded, samples);
        }
}

TEST_CASE("Many player hand-overs in a row never make the callback allocate, lock or wait") {
    if (!realTimeTrapWorks())
        SKIP("the trap needs Linux with glibc and no sanitizer");
    WatchedHost host(64);
    const auto music = testMusic(64, 16);
    const auto a = encodeState(testState("a")), b = encodeState(testState("b", 2));
    std::atomic<bool> stop{false};
    std::thread message([&] {
        for (int i = 0; i < 60; ++i) {
            restoreBytes(host.processor, i % 2 == 0 ? a : b);
            host.processor.view().status.takeStatus();
            saved(host.processor);
        }
        stop = true;
    });
    while (!stop)
        host.block(music, 64);
    message.join();
    CHECK(host.loudestSample > 0.001f);
}
