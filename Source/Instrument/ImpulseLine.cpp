#include "Instrument/ImpulseLine.h"

#include "Instrument/FactoryContent.h"
#include "Object/FileBytes.h"

#include <nlohmann/json.hpp>

namespace idiophone {

std::string objectInList(const std::string& nameOrFile, const std::filesystem::path& list) {
    if (factoryObject(nameOrFile))
        return nameOrFile;
    std::error_code fault;
    const auto whole = [&](const std::filesystem::path& path) {
        return std::filesystem::absolute(path, fault).lexically_normal();
    };
    const auto file = whole(pathNamed(nameOrFile));
    const auto fromList = file.lexically_relative(whole(list).parent_path());
    auto name = storedNameOf(fromList);
    if (fromList.empty() || *fromList.begin() == ".." || factoryObject(name))
        name = storedNameOf(file);
    return name;
}

std::string impulseLine(const std::string& object, double sizeRatio, const PlacedImpact& impact) {
    nlohmann::ordered_json line{{"time", impact.seconds},
                                {"object", object},
                                {"body", impact.slot},
                                {"point", impact.pointMetres},
                                {"impulse", impact.strike.impulseNewtonSeconds},
                                {"contact_time", impact.strike.durationSeconds}};
    if (sizeRatio != 1)
        line["size"] = sizeRatio;
    // A path that is not UTF-8 cannot be written in a list; keep the rest of the line.
    return line.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

} // namespace idiophone
