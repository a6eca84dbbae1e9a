#include "Console/MaterialFile.h"

#include "Console/TextFile.h"

#include <filesystem>

namespace idiophone {
namespace {

using nlohmann::ordered_json;

struct Figure {
    const char* key;
    double Material::*member;
    bool required;
};

constexpr Figure figures[] = {
    {"youngs_modulus_pa", &Material::youngsModulusPa, true},
    {"density_kg_per_m3", &Material::densityKgPerM3, true},
    {"poisson_ratio", &Material::poissonRatio, true},
    {"fluid_damping_per_s", &Material::fluidDampingPerSecond, true},
    {"viscoelastic_damping_s", &Material::viscoelasticDampingSeconds, true},
    {"friction", &Material::friction, false},
    {"restitution", &Material::restitution, false},
    {"roughness", &Material::roughness, false},
};

struct Word {
    const char* key;
    std::string Material::*member;
};

constexpr Word words[] = {{"name", &Material::name}, {"source", &Material::source}};

const Figure* findFigure(const std::string& key) {
    for (const auto& figure : figures)
        if (key == figure.key)
            return &figure;
    return nullptr;
}

const Word* findWord(const std::string& key) {
    for (const auto& word : words)
        if (key == word.key)
            return &word;
    return nullptr;
}

/// The first thing wrong with the file's members, which go into `material`; empty where all is
/// well.
std::string parseMembers(const ordered_json& root, Material& material) {
    if (!root.is_object())
        return "it is not a JSON object";
    for (const auto& [key, value] : root.items()) {
        const auto* figure = findFigure(key);
        const auto* word = findWord(key);
        if (figure == nullptr && word == nullptr)
            return "a material has no '" + key + "'";
        if (figure != nullptr && !value.is_number())
            return "'" + key + "' is not a number";
        if (word != nullptr && !value.is_string())
            return "'" + key + "' is not a text";
        if (figure != nullptr)
            material.*figure->member = value;
        else
            material.*word->member = value;
    }
    for (const auto& figure : figures)
        if (figure.required && !root.contains(figure.key))
            return "it lacks '" + std::string(figure.key) + "'";
    return {};
}

Result<Material> readMaterial(const std::string& file) {
    const auto text = readTextFile(file);
    if (!text)
        return tl::unexpected(text.error());
    Material material;
    material.name = std::filesystem::path(file).stem().string();
    const auto root = ordered_json::parse(*text, nullptr, false);
    if (root.is_discarded())
        return failure(file + ": it is not JSON");
    if (const auto fault = parseMembers(root, material); !fault.empty())
        return failure(file + ": " + fault);
    auto checked = validated(std::move(material));
    if (!checked)
        return failure(file + ": " + checked.error().message);
    return checked;
}

} // namespace

Result<Material> findOrReadMaterial(const std::string& nameOrFile) {
    if (const auto* known = findMaterial(nameOrFile))
        return *known;
    std::error_code ignored;
    if (!std::filesystem::exists(nameOrFile, ignored))
        return failure(nameOrFile + ": it is neither a material of the library (`idiophone "
                                    "materials` lists them) nor a file");
    return readMaterial(nameOrFile);
}

ordered_json describe(const Material& material) {
    ordered_json result{{"name", material.name}};
    for (const auto& figure : figures)
        result[figure.key] = material.*figure.member;
    result["source"] = material.source;
    return result;
}

} // namespace idiophone
