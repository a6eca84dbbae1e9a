#include "ResonatorParts.h"

#include <catch2/catch_test_macros.hpp>

using namespace idiophone;
using namespace idiophone::test;

namespace {

struct Contacts : ResonatorParts {
    Contacts() : ResonatorParts(ringingObject({440, 700}, 20)) {}

    Contact held(double seconds) {
        Contact contact{.strike = unitStrike(seconds), .listening = {}, .startSample = 10};
        contacts.compute(contact);
        active.join({bank.poles().audibleWeights(), 0, bank.energies()}, 2, false, 1);
        contacts.hold(contact, active.mixedRuns());
        return contact;
    }

    PendingIncrements increments{bank, output, active, scratch};
    ContactSet contacts{object, bank, output, active, residues, scratch};
};

} // namespace

TEST_CASE("A contact ends in its cell and leaves pending increments") {
    Contacts set;
    set.contacts.add(set.held(2e-3)); // 96 samples from sample 10
    std::array<float, cellSamples> cell{};
    set.contacts.mix(set.increments, 0, cell);
    CHECK(!set.contacts.empty());
    CHECK(!set.increments.pending());
    CHECK(cell[9] == 0.0f);
    CHECK(cell[20] != 0.0f);
    cell = {};
    set.contacts.mix(set.increments, 1, cell);
    CHECK(set.contacts.empty());
    CHECK(set.increments.pending());
    CHECK(set.bank.state(0).x == 0.0);
    set.increments.takeIn(2);
    CHECK(!set.increments.pending());
    CHECK(std::abs(set.bank.state(0).x) > 0.1);
}

TEST_CASE("Freeing and holding a contact under the same poles changes nothing") {
    Contacts set;
    set.contacts.add(set.held(5e-3));
    set.contacts.free(1);
    const double freed = std::abs(set.bank.state(0).x) + std::abs(set.bank.state(0).y);
    CHECK(freed > 1e-3);
    set.contacts.holdAgain(1);
    CHECK(std::abs(set.bank.state(0).x) < 1e-6 * freed);
    CHECK(std::abs(set.bank.state(0).y) < 1e-6 * freed);
}
