#include "Console/Command.h"
#include "Console/JsonText.h"
#include "Console/MaterialChoice.h"
#include "Console/TextColumns.h"
#include "Object/FileBytes.h"
#include "Object/MaterialFile.h"
#include "Object/NumberText.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <sstream>

namespace idiophone {
namespace {

using nlohmann::ordered_json;

struct MaterialsOptions {
    std::string material; ///< empty: all materials
    bool sources = false;
    bool json = false;
};

constexpr std::array<int, 3> shownHz{440, 1000, 4000};

/// A material without damping has an infinite T60, which JSON cannot express.
ordered_json describeWithDecay(const Material& material) {
    auto result = describe(material);
    for (const int hz : shownHz) {
        const double seconds = decaySeconds(material, hz);
        result["t60_s"][std::to_string(hz)] =
            std::isfinite(seconds) ? ordered_json(seconds) : nullptr;
    }
    return result;
}

/// Prints the sources of the figures on separate lines if the file has several.
void printSource(std::string source) {
    for (const std::string part : {"density", "damping", "contact"})
        if (const auto at = source.find("; " + part + ": "); at != std::string::npos)
            source.replace(at, 2, "\n");
    std::istringstream lines(source);
    for (std::string line; std::getline(lines, line);)
        std::cout << "    " << paragraph(line, 6);
}

void print(const Material& material, std::size_t nameWidth) {
    const auto& damping = material.damping;
    std::cout << leftColumn(material.name, nameWidth)
              << rightColumn(numberText(material.youngsModulusPa / 1e9, 4), 6)
              << rightColumn(numberText(material.densityKgPerM3, 5), 8)
              << rightColumn(numberText(material.poissonRatio, 4), 6)
              << rightColumn(numberText(damping.fluidPerSecond, 4), 7)
              << rightColumn(numberText(damping.lossFactor, 4), 8)
              << rightColumn(numberText(damping.viscoelasticSeconds * 1e6, 4), 7);
    for (const int hz : shownHz)
        std::cout << rightColumn(numberText(decaySeconds(material, hz), 3), 7);
    std::cout << '\n';
}

/// Prints in the units of the custom material's parameters.
void print(std::span<const Material> materials, bool withSources) {
    std::size_t nameWidth = 16;
    for (const auto& material : materials)
        nameWidth = std::max(nameWidth, material.name.size() + 1);
    std::cout << leftColumn("", nameWidth)
              << " young density    nu  gamma    loss    eta  T60 in s at Hz\n"
              << leftColumn("", nameWidth)
              << "   GPa   kg/m³          1/s  factor     µs    440   1000   4000\n";
    for (const auto& material : materials) {
        print(material, nameWidth);
        if (withSources)
            printSource(material.source);
    }
}

void listAll(const MaterialsOptions& options) {
    const auto library = materialLibrary();
    std::vector<Material> materials(library.begin(), library.end());
    const auto user = readMaterialFolder(userMaterialFolder());
    materials.insert(materials.end(), user.materials.begin(), user.materials.end());
    if (options.json) {
        auto all = ordered_json::array();
        std::ranges::transform(materials, std::back_inserter(all), describeWithDecay);
        std::cout << jsonText(all);
    } else {
        print(materials, options.sources);
        std::cout << "\n--sources shows the sources of the figures.\nPut your own materials into "
                  << nameOf(userMaterialFolder()) << '\n';
    }
    for (const auto& fault : user.faults)
        std::cerr << "idiophone: " << fault.message << '\n';
}

Result<void> listMaterials(const MaterialsOptions& options) {
    if (options.material.empty()) {
        listAll(options);
        return {};
    }
    const auto material = findOrReadMaterial(options.material);
    if (!material)
        return tl::unexpected(material.error());
    if (options.json)
        std::cout << jsonText(describeWithDecay(*material));
    else
        print(std::span(&*material, 1), true);
    return {};
}

} // namespace

void addMaterials(CLI::App& program, Action& chosen) {
    const auto [command, options] = addCommand<MaterialsOptions>(
        program, chosen, "materials", "Lists the materials, or describes one", listMaterials);
    command->add_option("MATERIAL", options->material, "Name of a material, or a JSON file");
    command->add_flag("--sources", options->sources, "Shows the sources of all figures");
    command->add_flag("--json", options->json,
                      "Writes JSON: a list of all, or one material that --material can read");
}

} // namespace idiophone
