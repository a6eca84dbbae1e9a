#include "Plugin/MaterialSession.h"

#include "Instrument/SettingsOfParameters.h"
#include "Object/MaterialFile.h"

#include <algorithm>
#include <array>
#include <utility>

namespace idiophone {

std::vector<std::string> MaterialSession::readUserMaterials() {
    auto found = readMaterialFolder(userMaterialFolder());
    materials = std::move(found.materials);
    if (!found.faults.empty())
        session.reportError(found.faults.front().message);
    return userMaterialNames();
}

std::vector<std::string> MaterialSession::userMaterialNames() const {
    std::vector<std::string> names;
    for (const auto& material : materials)
        names.push_back(material.name);
    return names;
}

bool MaterialSession::contains(const std::string& name) const {
    return std::ranges::find(materials, name, &Material::name) != materials.end();
}

void MaterialSession::choose(const std::string& name) {
    const auto names = readUserMaterials();
    if (const auto found = std::ranges::find(names, name); found != names.end())
        chooseUserMaterial(static_cast<int>(found - names.begin()));
}

int MaterialSession::userMaterialIndex() const {
    const auto now = parameters.values();
    const auto played = std::ranges::find_if(materials, [&](const Material& material) {
        return withCustomMaterial(now, material) == now;
    });
    return played == materials.end() ? -1
                                     : static_cast<int>(std::distance(materials.begin(), played));
}

void MaterialSession::chooseUserMaterial(int index) {
    if (index < 0 || index >= static_cast<int>(materials.size()))
        return;
    const auto& chosen = materials[static_cast<std::size_t>(index)];
    const auto wanted = withCustomMaterial(parameters.values(), chosen);
    history.beginEdit(chosen.name);
    edits.changeTo(wanted, materialFigures);
    edits.changeTo(wanted, std::array{ParameterId::material}); // last, as in `makeCustom`
    history.endEdit();
}

} // namespace idiophone
