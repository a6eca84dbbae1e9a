#include "Object/Mallet.h"

#include "Object/ColourText.h"
#include "Object/EmbeddedLists.h"

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace idiophone {
namespace {

struct Rack {
    nlohmann::json file = nlohmann::json::parse(embeddedMallets()); ///< has the texts
    std::vector<Mallet> mallets;

    // A part of the program, and the tests read all of it: what is wrong in it ends the program.
    Rack() noexcept {
        const auto text = [](const nlohmann::json& value) -> std::string_view {
            return value.get_ref<const std::string&>();
        };
        for (const auto& mallet : file.at("mallets"))
            mallets.push_back({.name = text(mallet.at("name")),
                               .source = text(mallet.at("source")),
                               .massKg = mallet.at("mass_kg"),
                               .headRadiusMetres = mallet.at("head_radius_m"),
                               .effectiveModulusPa = mallet.at("effective_modulus_pa"),
                               .forceExponent = mallet.at("force_exponent"),
                               .colour = parseColour(text(mallet.at("colour"))).value()});
    }
};

const Rack& rack() {
    static const Rack onlyOne;
    return onlyOne;
}

// Read before anything runs: the audio thread must not be the first to ask.
[[maybe_unused]] const auto& readAtStart = rack();

} // namespace

std::span<const Mallet> malletRack() {
    return rack().mallets;
}

} // namespace idiophone
