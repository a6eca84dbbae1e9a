// Fuzzes surfaces, as `idiophone surface` saves them.
#include "Fuzz/FuzzTarget.h"
#include "Instrument/SurfaceFile.h"

void idiophone::fuzz::examine(std::string_view bytes) {
    const auto surface = parseSurface(bytes, "fuzz.json");
    if (!surface)
        return claimSentence(surface.error());
    claim(validated(*surface).has_value(), "figures are in range");
    const auto again = parseSurface(encodeSurface(*surface), "again.json");
    claim(again && *again == *surface, "a surface that was written reads back equal");
}
