#include "Plugin/TailLength.h"

#include "Plugin/SessionParts.h"
#include "Support/Routes.h"

#include <cmath>

using namespace idiophone;
using namespace idiophone::test;

TEST_CASE("A tail grows with the room and with lower tunings, up to its maximum") {
    TailLength tail;
    EngineReport report;
    const auto sound = testSound();
    tail.setInstrument(sound.instrument);
    auto values = sound.parameters;
    values.set(ParameterId::room, 0);
    const double dry = tail.seconds(values, report);
    CHECK(dry > 0);
    values.set(ParameterId::room, 0.5);
    CHECK(tail.seconds(values, report) > dry);
    values.set(ParameterId::room, 0);

    KeyTuning lower;
    lower.semitonesFromEqual.fill(-24);
    tail.setTuning(lower);
    const double low = tail.seconds(values, report);
    CHECK(low > dry);
    tail.setTuning({});
    report.semitonesBelowEqual = 24 + values[ParameterId::bendRange];
    CHECK(tail.seconds(values, report) == low);
    values.set(ParameterId::material, customMaterial);
    values.set(ParameterId::fluidDamping, 0.01);
    values.set(ParameterId::viscoelasticDamping, 0.0001);
    values.set(ParameterId::lossFactor, 0);
    report.semitonesBelowEqual = 1000;
    CHECK(tail.seconds(values, report) == TailLength::maximumSeconds);
}

TEST_CASE("A tail is as long as the decay that modulation can reach") {
    TailLength tail;
    const EngineReport report;
    const auto sound = testSound();
    tail.setInstrument(sound.instrument);
    auto values = sound.parameters;
    values.set(ParameterId::room, 0);
    const double plain = tail.seconds(values, report);
    const auto& decay = parameterInfo(ParameterId::decay);
    const double upTo4 = 100 * (decay.toNormalised(4) - decay.toNormalised(1));
    auto longer = values;
    longer.set(ParameterId::decay, 4);
    const double longest = tail.seconds(longer, report);
    REQUIRE(longest > 1.5 * plain);
    REQUIRE(longest < TailLength::maximumSeconds);
    const auto secondsWith = [&](ModulationSource source, double amount) {
        return tail.seconds(routed(3, source, ParameterId::decay, amount, values), report);
    };
    CHECK(std::abs(secondsWith(ModulationSource::velocity, upTo4) - longest) < 1e-9);
    CHECK(std::abs(secondsWith(ModulationSource::lfo1, -upTo4) - longest) < 1e-9);
    CHECK(secondsWith(ModulationSource::velocity, -upTo4) == plain);
}
