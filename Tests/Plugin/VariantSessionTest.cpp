#include "Plugin/VariantSession.h"

#include "Plugin/SessionParts.h"

using namespace idiophone;
using namespace idiophone::test;
using enum ParameterId;

namespace {

struct VariantParts : SessionParts {
    VariantParts() { play(); }

    double densityNow() const { return parameters[density].exactValue(); }

    VariantSession variants{session, history};
};

} // namespace

TEST_CASE("The other variant starts as a copy, and comparing switches between the two") {
    VariantParts parts;
    const double inA = parts.densityNow();
    parts.variants.compare();
    CHECK(parts.variants.playsB());
    CHECK(parts.densityNow() == inA);
    parts.parameters[density].setExactValue(1234);
    parts.variants.compare();
    CHECK_FALSE(parts.variants.playsB());
    CHECK(parts.densityNow() == inA);
    parts.variants.compare();
    CHECK(parts.densityNow() == 1234);
    CHECK(parts.history.undoName() == "Compare with B");
    parts.history.undo();
    CHECK_FALSE(parts.variants.playsB());
    CHECK(parts.densityNow() == inA);
}

TEST_CASE("Copying replaces the other variant and leaves the sound") {
    VariantParts parts;
    const double former = parts.densityNow();
    parts.variants.copyToOther();
    parts.parameters[density].setExactValue(1234);
    parts.variants.copyToOther();
    CHECK(parts.history.undoName() == "Copy A to B");
    parts.parameters[density].setExactValue(4321);
    parts.variants.compare();
    CHECK(parts.densityNow() == 1234);
    parts.history.undo();
    CHECK(parts.densityNow() == 4321);
    parts.history.undo();
    parts.variants.compare();
    CHECK(parts.densityNow() == former);
}

TEST_CASE("A mutation is one step, and its seed decides about its values") {
    VariantParts parts;
    const auto before = parts.parameters.values();
    const auto mutatedBy = [&](std::uint32_t seed) {
        parts.variants.mutate(1, seed);
        CHECK(parts.history.undoName() == "Mutate");
        const auto values = parts.parameters.values();
        parts.history.undo();
        CHECK(parts.parameters.values() == before);
        return values;
    };
    const auto values = mutatedBy(7);
    CHECK(values != before);
    CHECK(mutatedBy(7) == values);
    CHECK(mutatedBy(8) != values);
}

TEST_CASE("An auditioned sound stays when it is copied") {
    VariantParts parts;
    const auto other = testSound("other");
    parts.history.audition([&] { parts.session.playSound(other); });
    parts.variants.copyToOther();
    parts.history.endAudition();
    CHECK(parts.session.instrument() == other.instrument);
}
