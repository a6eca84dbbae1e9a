#include "Parameters/ModulationTable.h"

#include "Support/Routes.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <set>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Approx;
using enum ParameterId;

TEST_CASE("Modulation reaches every parameter of a sound that glides") {
    std::set<ParameterId> targets;
    for (const auto target : modulationTargets()) {
        INFO(parameterInfo(target).id);
        CHECK(targets.insert(target).second);
        CHECK(modulationTargets()[static_cast<std::size_t>(modulationTargetChoice(target)) - 1] ==
              target);
    }
    for (const auto& info : parameterTable())
        if (info.glides && !info.isSetup) {
            INFO(info.id);
            CHECK(targets.contains(info.parameter));
        }
    CHECK(modulationTargetChoice(limiter) == 0);
}

TEST_CASE("Sources and targets are chosen by their names") {
    const auto& target = parameterInfo(modulation1Target);
    CHECK(parseParameter(target, "Mallet hardness") ==
          double(modulationTargetChoice(malletHardness)));
    CHECK(formatParameter(target, modulationTargetChoice(size)) == "Size");
    CHECK_FALSE(parseParameter(target, "Limiter"));
    CHECK(parseParameter(parameterInfo(modulation8Source), "random") ==
          double(ModulationSource::random));
    for (const auto& lfo : lfoParameters)
        for (std::size_t choice = 0; choice < choiceNames(lfo.sync).size(); ++choice)
            CHECK((lfoSyncBeats(static_cast<int>(choice)) > 0) == (choice > 0));
    CHECK(lfoSyncBeats(int(*parseParameter(parameterInfo(lfo1Sync), "1/8 T"))) == Approx(1.0 / 3));
}

TEST_CASE("A route moves its target on the target's own scale, within its range") {
    const ActiveRoutes routes(routed(2, ModulationSource::velocity, size, 25));
    ActiveRoutes::Inputs inputs{};
    CHECK(routes.moved(size, 1, inputs) == 1);
    inputs[2] = 1;
    CHECK(routes.moved(size, 1, inputs) == Approx(std::sqrt(10)));
    inputs[2] = -2;
    CHECK(routes.moved(size, 1, inputs) == Approx(0.1));
    inputs[2] = 4;
    CHECK(routes.moved(size, 1, inputs) == 10);
    CHECK(routes.moved(decay, 1, inputs) == 1);
}

TEST_CASE("Routes to one target add up") {
    auto values = routed(0, ModulationSource::lfo1, tune, 10);
    values = routed(7, ModulationSource::key, tune, -40, values);
    const ActiveRoutes routes(values);
    ActiveRoutes::Inputs inputs{};
    inputs[0] = 0.5;
    inputs[7] = 0.25;
    CHECK(routes.moved(tune, 100, inputs) == Approx(100 + 2400 * (0.05 - 0.1)));
}

TEST_CASE("A route to the amount of another one moves that amount") {
    auto values = routed(0, ModulationSource::lfo1, tune, 0);
    values = routed(1, ModulationSource::wheel, modulation1Amount, 25, values);
    const ActiveRoutes routes(values);
    ActiveRoutes::Inputs inputs{};
    inputs[0] = 1;
    CHECK(routes.moved(tune, 0, inputs) == 0);
    inputs[1] = 0.5; // half of a quarter of the range from -100 to 100 %
    CHECK(routes.moved(tune, 0, inputs) == Approx(0.25 * 2400));
}

TEST_CASE("Routes without a source, a target or an amount do not act") {
    CHECK(ActiveRoutes(ParameterValues()).empty());
    CHECK(ActiveRoutes(routed(0, ModulationSource::none, tune, 50)).empty());
    CHECK(ActiveRoutes(routed(0, ModulationSource::lfo1, limiter, 50)).empty());
    CHECK(ActiveRoutes(routed(0, ModulationSource::lfo1, tune, 0)).empty());
    const ActiveRoutes routes(routed(0, ModulationSource::lfo1, tune, 1));
    CHECK(routes.moves(tune));
    CHECK(routes.uses(ModulationSource::lfo1));
    CHECK_FALSE(routes.uses(ModulationSource::lfo2));
}

TEST_CASE("A modulated range reaches to both sides for an LFO, and to one for velocity") {
    const auto swinging = modulatedRange(routed(0, ModulationSource::lfo2, tune, 10), tune);
    CHECK(swinging.lowest == Approx(-240));
    CHECK(swinging.highest == Approx(240));
    const auto struck = modulatedRange(routed(0, ModulationSource::velocity, tune, -10), tune);
    CHECK(struck.lowest == Approx(-240));
    CHECK(struck.highest == 0);
    auto byWheel = routed(0, ModulationSource::velocity, tune, 0);
    byWheel = routed(1, ModulationSource::wheel, modulation1Amount, 5, byWheel);
    CHECK(modulatedRange(byWheel, tune).highest == 1200);
    CHECK(modulatedRange(byWheel, decay).lowest == modulatedRange(byWheel, decay).highest);
}
