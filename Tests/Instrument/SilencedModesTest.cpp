#include "Instrument/SilencedModes.h"
#include "TestInstruments.h"

#include <catch2/catch_test_macros.hpp>

using namespace idiophone;
using namespace idiophone::test;

TEST_CASE("Muted modes are silenced; soloed modes silence the other modes of their object") {
    const auto instrument = bars();
    CHECK(modeSetKey(*instrument, 2) == "62");
    ModeSet muted, alone;
    CHECK(silencedModes(*instrument, muted, alone).objects.empty());
    muted.set("62", 1, true);
    muted.set("64", 1, true);
    muted.set("62", 7, true);      // the object lacks this mode
    muted.set("nothing", 0, true); // the instrument lacks this object
    alone.set("64", 1, true);
    alone.set("62", 9, true);
    const auto silenced = silencedModes(*instrument, muted, alone);
    REQUIRE(silenced.objects.size() == 2);
    CHECK(silenced.objects[0].object == instrument->slots()[2].object.get());
    CHECK(silenced.objects[0].isSilenced == std::vector<std::uint8_t>{0, 1});
    CHECK(silenced.objects[1].object == instrument->slots()[4].object.get());
    CHECK(silenced.objects[1].isSilenced == std::vector<std::uint8_t>{1, 0});
}

TEST_CASE("Slots that share an object are silenced once") {
    const auto instrument = keysOn(syntheticObject({300, 810}), KeyMapKind::scaled, 60, 72);
    ModeSet muted;
    muted.set(modeSetKey(*instrument, 5), 0, true);
    const auto silenced = silencedModes(*instrument, muted, {});
    REQUIRE(silenced.objects.size() == 1);
    CHECK(silenced.objects[0].isSilenced == std::vector<std::uint8_t>{1, 0});
}
