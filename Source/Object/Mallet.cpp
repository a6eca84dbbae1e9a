// SPDX-License-Identifier: Apache-2.0
#include "Object/Mallet.h"

#include "Object/ColourText.h"
#include "Object/EmbeddedLists.h"

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace idiophone {
namespace {

struct Rack {
    nlohmann::json file = nlohmann::json::parse(embeddedMallets()); ///< owns the texts
    std::vector<Mallet> mallets;

    // The list is part of the program and is tested. An error in it ends the program.
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

// Parse the list at startup, so that the audio thread is never the first to use it.
[[maybe_unused]] const auto& readAtStart = rack();

} // namespace

std::span<const Mallet> malletRack() {
    return rack().mallets;
}

} // namespace idiophone
