#include "Analysis/RecordedMaterial.h"

#include "Analysis/BodyModel.h"
#include "Object/FileBytes.h"
#include "Object/NumberText.h"

#include <array>
#include <cmath>

namespace idiophone {
namespace {

Result<MaterialFit> fitted(const RecordingFit& modes,
                           const StrikeRecording& recording,
                           const std::optional<StruckObject>& object,
                           const WorkControl& control) {
    const auto refuse = [](const std::string& file, const std::string& why) {
        return failure(file + ": " + why);
    };
    if (!object)
        return fitDampingOnly(modes.modes).map_error([&](const Error& error) {
            return refuse(recording.name, error.message).value();
        });
    AnalysisSettings settings;
    settings.name = settings.source = object->name;
    settings.method = object->method;
    settings.thicknessMetres = object->thicknessMetres;
    auto fit = fitMaterial(modes.modes, object->mesh, settings, control);
    if (!fit)
        return isCancellation(fit.error()) ? tl::unexpected(fit.error())
                                           : refuse(object->name, fit.error().message);
    if (!*fit)
        return refuse(recording.name,
                      "its modes are not those of " + object->name + ", whatever the material");
    return std::move(**fit);
}

std::string findingsOf(const MaterialFit& fit) {
    const auto& material = fit.material;
    auto text =
        "like " + fit.resembles + ", speed of sound " +
        std::to_string(std::lround(std::sqrt(material.youngsModulusPa / material.densityKgPerM3))) +
        " m/s; rings (T60)";
    for (const int hz : std::array{440, 1000, 4000})
        text += (hz == 440 ? " " : ", ") + numberText(decaySeconds(material, hz), 3) + " s at " +
                std::to_string(hz) + " Hz";
    return text;
}

std::string notesOf(const MaterialFit& fit,
                    const RecordingFit& modes,
                    const std::optional<StruckObject>& object) {
    auto notes = object ? std::to_string(fit.matched) + " of the " +
                              std::to_string(modes.modes.size()) + " modes are those of " +
                              object->name + ". Density"
                        : std::string("The shape of the object is unknown, so only the damping is "
                                      "fitted. Stiffness, density");
    notes += " and contact figures are those of " + fit.resembles + ".";
    if (fit.otherRatio)
        notes += " A stiffness " + numberText(*fit.otherRatio, 3) +
                 " times as high explains the modes nearly as well.";
    for (const auto& remark : modes.remarks)
        notes += ' ' + remark;
    return joinedSentences({notes, object ? object->notes : std::string()});
}

} // namespace

Result<RecordedMaterial> materialOfRecording(const StrikeRecording& recording,
                                             const std::string& name,
                                             const std::optional<StruckObject>& object,
                                             const WorkControl& control) {
    const double fitShare = object ? 0.3 : 1;
    const auto modes = fitRecordings(std::array{recording}, {}, control.part(0, fitShare));
    if (!modes)
        return tl::unexpected(modes.error());
    auto fit = fitted(*modes, recording, object, control.part(fitShare, 1));
    if (!fit)
        return tl::unexpected(fit.error());
    auto& material = fit->material;
    material.name = name;
    material.source = (object ? "stiffness and damping" : "damping") + std::string(" fitted to ") +
                      nameOf(pathNamed(recording.name).filename()) + "; all else is that of " +
                      fit->resembles;
    if (auto valid = validated(material); !valid)
        return failure(recording.name + ": " + valid.error().message);
    auto findings = findingsOf(*fit);
    auto notes = notesOf(*fit, *modes, object);
    return RecordedMaterial{
        .fit = std::move(*fit), .findings = std::move(findings), .notes = std::move(notes)};
}

} // namespace idiophone
