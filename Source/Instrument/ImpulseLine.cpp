#include "Instrument/ImpulseLine.h"

#include <nlohmann/json.hpp>

namespace idiophone {

std::string impulseLine(const SynthesiserSlot& struck, const PlacedBlow& blow) {
    nlohmann::ordered_json line{{"time", blow.seconds},
                                {"object", struck.object->name},
                                {"body", blow.slot},
                                {"point", blow.pointMetres},
                                {"impulse", blow.strike.impulseNewtonSeconds},
                                {"contact_time", blow.strike.durationSeconds}};
    if (struck.sizeRatio != 1)
        line["size"] = struck.sizeRatio;
    return line.dump() + "\n";
}

} // namespace idiophone
