// Fuzzes surfaces, as `idiophone surface` saves them.
#include "Fuzz/FuzzTarget.h"
#include "Instrument/JsonPlace.h"
#include "Instrument/SurfaceFile.h"

void idiophone::fuzz::examine(std::string_view bytes) {
    const auto surface = parsedJson(bytes, "fuzz.json", surfaceAt);
    if (!surface)
        return claimSentence(surface.error());
    claim(validated(*surface).has_value(), "figures are in range");
    const auto again = parsedJson(encodeSurface(*surface), "again.json", surfaceAt);
    claim(again && *again == *surface, "a surface that was written reads back equal");
}
