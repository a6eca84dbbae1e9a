// The material that objects have now, by the parameters.
#pragma once

#include "Editor/Appearance.h"
#include "Editor/ProcessorView.h"

#include <vector>

namespace idiophone {

/// The figures in effect, without a name or grain.
inline Material figuresInEffect(const ProcessorView& view) {
    using enum ParameterId;
    const auto value = [&](ParameterId id) { return view.parameters.effectiveValue(id); };
    Material now;
    now.youngsModulusPa = value(youngsModulus) * 1e9;
    now.densityKgPerM3 = value(density);
    now.damping = {.fluidPerSecond = value(fluidDamping),
                   .viscoelasticSeconds = value(viscoelasticDamping) * 1e-6,
                   .lossFactor = value(lossFactor)};
    return now;
}

/// The appearances of objects: by their own materials, the library's, or the custom figures.
inline std::vector<Appearance>
appearancesOf(const ProcessorView& view, const std::vector<InstrumentView::PlayedObject>& played) {
    const auto choice = static_cast<int>(view.parameters.value(ParameterId::material));
    const auto library = materialLibrary();
    const auto named = static_cast<std::size_t>(choice - firstLibraryMaterial);
    std::vector<Appearance> result;
    if (choice == ownMaterial || (choice >= firstLibraryMaterial && named >= library.size()))
        for (const auto& each : played)
            result.push_back(appearanceOf(each.object->material));
    else
        result.assign(played.size(), appearanceOf(choice == customMaterial ? figuresInEffect(view)
                                                                           : library[named]));
    return result;
}

} // namespace idiophone
