// SPDX-License-Identifier: Apache-2.0
#include "Object/MaterialText.h"

#include "Object/ColourText.h"
#include "Object/MaterialJson.h"
#include "Object/MaterialKind.h"
#include "Object/OneLine.h"
#include "Object/UntrustedJson.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

namespace idiophone {
namespace {

// json is sorted, so that reading stays fast for a hostile file with many keys. ordered_json writes
// keys in an order for readers.
using nlohmann::json;
using nlohmann::ordered_json;

constexpr std::size_t longestNameBytes = 100;

// Inside this file errors are exceptions. The public functions turn them into a Result.
struct Fault {
    std::string sentence;
};

const MaterialFigure* findFigure(const std::string& key) {
    for (const auto group : materialFigureGroups)
        for (const auto& figure : group)
            if (key == figure.key)
                return &figure;
    return nullptr;
}

std::string parseName(const json& value) {
    if (!value.is_string())
        throw Fault{"'name' is not a text"};
    const auto name = value.get<std::string>();
    if (name.empty())
        throw Fault{"its name is empty"};
    if (name.size() > longestNameBytes)
        throw Fault{"its name is longer than " + std::to_string(longestNameBytes) + " bytes"};
    if (std::ranges::any_of(name, [](unsigned char c) { return c < ' ' || c == 127; }))
        throw Fault{"its name holds control characters"};
    return name;
}

/// Joins a text, or texts by topic, to one text.
std::string parseSource(const json& value) {
    if (value.is_string())
        return value;
    if (!value.is_object())
        throw Fault{"'source' is neither a text nor a JSON object of texts"};
    std::string all;
    for (const char* part : {"elasticity", "density", "damping", "contact"}) {
        if (!value.contains(part))
            continue;
        if (!value[part].is_string())
            throw Fault{"'source' has '" + std::string(part) + "' that is not a text"};
        all +=
            (all.empty() ? "" : "; ") + std::string(part) + ": " + value[part].get<std::string>();
    }
    for (const auto& [part, text] : value.items())
        if (part != "elasticity" && part != "density" && part != "damping" && part != "contact")
            throw Fault{"'source' has no " + inQuotes(part)};
    return all;
}

void requireFigures(const json& object) {
    const auto isThere = [&](const MaterialFigure& figure) { return object.contains(figure.key); };
    for (const auto& figure : elasticityFigures)
        if (!isThere(figure))
            throw Fault{"it lacks '" + std::string(figure.key) + "'"};
    if (std::ranges::none_of(dampingFigures, isThere))
        throw Fault{"it has no damping: 'fluid_damping_per_s', 'viscoelastic_damping_s' or "
                    "'loss_factor'"};
}

Material parseObject(const json& object, const std::string& defaultName) {
    if (!object.is_object())
        throw Fault{"it is not a JSON object"};
    Material material;
    material.name = defaultName;
    for (const auto& [key, value] : object.items()) {
        if (const auto* figure = findFigure(key)) {
            if (!value.is_number())
                throw Fault{"'" + key + "' is not a number"};
            figure->of(material) = value;
        } else if (key == "name") {
            material.name = parseName(value);
        } else if (key == "source") {
            material.source = parseSource(value);
        } else if (key == "grain") {
            const auto grain = grainFrom(value);
            if (!grain)
                throw Fault{grain.error().message};
            material.grain = *grain;
        } else if (key == "colour") { // MaterialLibrary reads the colour
            if (!value.is_string() || !parseColour(value.get<std::string>()))
                throw Fault{"'colour' is not of the form '#6b3324'"};
        } else if (key == "kind") { // MaterialLibrary reads the kind
            if (!value.is_string() || !parseMaterialKind(value.get<std::string>()))
                throw Fault{"'kind' is none of wood, metal, glass, stone, ceramic and plastic"};
        } else if (key != "t60_s") { // `idiophone materials --json` adds the T60 for readers
            throw Fault{"a material has no " + inQuotes(key)};
        }
    }
    requireFigures(object);
    auto checked = validated(std::move(material));
    if (!checked)
        throw Fault{checked.error().message};
    return std::move(*checked);
}

std::vector<Material> parseList(const json& root) {
    if (!root.is_object() || !root.contains("format") || root["format"] != "idiophone-materials")
        throw Fault{"it is not a list of materials"};
    if (!root.contains("version") || root["version"] != 1)
        throw Fault{"its version is not 1"};
    if (!root.contains("materials") || !root["materials"].is_array())
        throw Fault{"it lacks a list 'materials'"};
    std::vector<Material> materials;
    std::set<std::string> names;
    for (const auto& entry : root["materials"]) {
        materials.push_back(parseObject(entry, {}));
        const auto& name = materials.back().name;
        if (name.empty())
            throw Fault{"one of its materials has no name"};
        if (!names.insert(name).second)
            throw Fault{"it has two materials " + inQuotes(name)};
    }
    return materials;
}

/// Applies `parse` to the text and turns all errors into a sentence about the file.
template <class Parse>
auto parsed(std::string_view text, std::string_view fileName, const Parse& parse)
    -> Result<decltype(parse(json()))> {
    const auto refuse = [&](const std::string& sentence) {
        return failure(shownName(fileName) + ": " + sentence);
    };
    if (text.size() > largestMaterialBytes)
        return refuse("it is too large for a material");
    try {
        const auto root = parseUntrusted(text);
        if (root.is_discarded())
            return refuse("it is not JSON" + placeOfJsonFault(text));
        return parse(root);
    } catch (const Fault& fault) {
        return refuse(fault.sentence);
    } catch (const json::exception&) {
        return refuse("it is damaged");
    }
}

} // namespace

Result<Material>
parseMaterial(std::string_view text, std::string_view fileName, std::string_view defaultName) {
    return parsed(text, fileName,
                  [&](const json& root) { return parseObject(root, std::string(defaultName)); });
}

Result<std::vector<Material>> parseMaterialList(std::string_view text, std::string_view fileName) {
    return parsed(text, fileName, parseList);
}

std::string encodeMaterial(const Material& material) {
    // Names come from people and files: replace invalid UTF-8 instead of throwing.
    return materialJson<ordered_json>(material).dump(4, ' ', false,
                                                     ordered_json::error_handler_t::replace);
}

} // namespace idiophone
