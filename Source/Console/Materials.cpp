#include "Console/Command.h"
#include "Console/JsonText.h"
#include "Console/MaterialChoice.h"
#include "Object/MaterialFile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <iostream>

namespace idiophone {
namespace {

using nlohmann::ordered_json;

struct Options {
    std::string material; ///< empty: all of them
    bool json = false;
};

constexpr std::array<int, 3> shownHz{440, 1000, 4000};

/// JSON has no infinity, which is the T60 of a material without damping.
ordered_json describeWithDecay(const Material& material) {
    auto result = describe(material);
    for (const int hz : shownHz) {
        const double seconds = decaySeconds(material, hz);
        result["t60_s"][std::to_string(hz)] =
            std::isfinite(seconds) ? ordered_json(seconds) : nullptr;
    }
    return result;
}

void print(const Material& material) {
    const auto& damping = material.damping;
    const auto column = [](double value, int width) {
        std::cout << std::setw(width) << value << ' ';
    };
    std::cout << std::left << std::setprecision(4) << std::setw(16) << material.name << ' ';
    column(material.youngsModulusPa / 1e9, 7);
    column(material.densityKgPerM3, 7);
    column(material.poissonRatio, 6);
    column(damping.fluidPerSecond, 9);
    column(damping.lossFactor, 8);
    column(damping.viscoelasticSeconds, 9);
    std::cout << std::setprecision(3);
    for (const int hz : shownHz)
        column(decaySeconds(material, hz), 7);
    std::cout << '\n';
    if (!material.source.empty())
        std::cout << "    " << material.source << '\n';
}

void print(std::span<const Material> materials) {
    std::cout
        << "                                         gamma     loss     eta       T60 in s at\n"
           "                 E GPa   kg/m³   nu     1/s       factor   s         "
           "440     1000    4000 Hz\n";
    for (const auto& material : materials)
        print(material);
}

void listAll(bool json) {
    const auto library = materialLibrary();
    std::vector<Material> materials(library.begin(), library.end());
    const auto user = readMaterialFolder(userMaterialFolder());
    materials.insert(materials.end(), user.materials.begin(), user.materials.end());
    if (json) {
        auto all = ordered_json::array();
        std::ranges::transform(materials, std::back_inserter(all), describeWithDecay);
        std::cout << jsonText(all);
    } else {
        print(materials);
        std::cout << "Materials of your own go into " << userMaterialFolder().string() << '\n';
    }
    for (const auto& fault : user.faults)
        std::cerr << "idiophone: " << fault.message << '\n';
}

Result<void> listMaterials(const Options& options) {
    if (options.material.empty()) {
        listAll(options.json);
        return {};
    }
    const auto material = findOrReadMaterial(options.material);
    if (!material)
        return tl::unexpected(material.error());
    if (options.json)
        std::cout << jsonText(describeWithDecay(*material));
    else
        print(std::span(&*material, 1));
    return {};
}

} // namespace

void addMaterials(CLI::App& program, Action& chosen) {
    auto* command = program.add_subcommand("materials", "Lists the materials, or checks one");
    auto options = std::make_shared<Options>();
    command->add_option("MATERIAL", options->material, "A material's name or a JSON file");
    command->add_flag("--json", options->json,
                      "As JSON: all in a list, or the one, which --material reads");
    command->final_callback(
        [options, &chosen] { chosen = [options] { return listMaterials(*options); }; });
}

} // namespace idiophone
