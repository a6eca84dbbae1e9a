// Plays random music in one processor, faster than real time, hour by hour. The first hours of a
// day change sounds and host settings, so that no player lasts long. The other hours use a single
// player. After each hour the output must fall silent, a reference phrase must sound as at first,
// and memory must not have grown over all hours of the log. Plays HOURS hours after the last one in
// the log.
//   soak_music LOG HOURS
#include "Soak/MemoryLog.h"
#include "Soak/RandomSession.h"
#include "Support/ResidentMemory.h"

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <juce_events/juce_events.h>
#include <optional>
#include <stdexcept>
#include <string>
#ifdef __GLIBC__
#include <malloc.h>
#endif

using namespace idiophone;
using namespace idiophone::test;

namespace {

constexpr double hourSeconds = 3600;
constexpr double farthestDb = 0.0001;
constexpr double farthestTremolo = 0.1; // a roll of ten seconds is noisy

/// Returns resident memory, without pages that the allocator can give back.
double residentMebibytes() {
#ifdef __GLIBC__
    ::malloc_trim(0);
#endif
    return residentKibibytes() / 1024;
}

void check(bool holds, const std::string& fault) {
    if (!holds)
        throw std::runtime_error(fault);
}

/// Reference sounds of the player that is kept for all hours.
struct Sounds {
    PlayedPhrase afterReset;
    double rms = 0, tremolo = 0;
};

class Soak {
public:
    void playHour(int hour) {
        const int ofDay = hourOfDay(hour);
        if (ofDay < shortLivedHours) {
            life.reset();
            play(manyLives, hour);
            check(manyLives.phraseAnew() == first, "The reference phrase has changed.");
            manyLives.settle();
            return;
        }
        if (!life)
            beginLife(dayOf(hour));
        play(oneLife, hour);
        check(std::abs(20 * std::log10(rmsLevel(oneLife.phrase()) / life->rms)) < farthestDb,
              "The reference phrase is louder or softer in a player that has lived for long.");
        oneLife.settle();
        check(std::abs(oneLife.tremolo() - life->tremolo) < farthestTremolo,
              "The motor turns otherwise in a player that has lived for long.");
        oneLife.settle();
        if (ofDay == hoursPerDay - 1) {
            check(oneLife.phraseAfterReset() == life->afterReset,
                  "A reset leaves something of a long life.");
            oneLife.settle();
        }
    }

    std::int64_t notesPlayed() const { return manyLives.notesPlayed() + oneLife.notesPlayed(); }

private:
    static void play(RandomSession& session, int hour) {
        session.play(hourSeconds, static_cast<std::uint64_t>(hour));
        session.settle();
    }

    void beginLife(int day) {
        oneLife.load(4 + 5 * day); // day by day: rings, bars, bowls
        life.emplace();
        life->afterReset = oneLife.phraseAfterReset();
        oneLife.settle();
        life->rms = rmsLevel(oneLife.phrase());
        oneLife.settle();
        life->tremolo = oneLife.tremolo();
        oneLife.settle();
    }

    Processor processor;
    RandomSession oneLife{processor, RandomSession::Changes::parameters};
    RandomSession manyLives{processor};
    const PlayedPhrase first = manyLives.phraseAnew();
    std::optional<Sounds> life; ///< of the current player, if it plays for hours
};

void soak(const std::string& log, int wantedHours) {
    Soak soak;
    std::ifstream before(log);
    auto hours = readHours(before);
    for (int ofProcess = 1; ofProcess <= wantedHours; ++ofProcess) {
        const int hour = hours.empty() ? 1 : hours.back().hour + 1;
        const auto notes = soak.notesPlayed();
        soak.playHour(hour);
        hours.push_back({hour, ofProcess, residentMebibytes()});
        std::ofstream(log, std::ios::app)
            << logLine(hours.back(), soak.notesPlayed() - notes) << std::endl;
        const auto growth = growthOf(hours);
        check(!growth, growth.value_or(""));
    }
}

} // namespace

int main(int count, char** arguments) {
    if (count != 3) {
        std::cerr << "soak_music LOG HOURS" << std::endl;
        return 2;
    }
    const juce::ScopedJuceInitialiser_GUI juce;
    try {
        soak(arguments[1], std::atoi(arguments[2]));
    } catch (const std::exception& fault) {
        std::cerr << fault.what() << std::endl;
        return 1;
    }
    return 0;
}
