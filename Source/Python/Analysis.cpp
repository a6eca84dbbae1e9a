#include "Analysis/MeasuredObject.h"
#include "Analysis/ModalAnalysis.h"
#include "Analysis/RecordedMaterial.h"
#include "Python/Binding.h"

#include <nanobind/stl/pair.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/variant.h>
#include <nanobind/stl/vector.h>

namespace idiophone::python {
namespace {

using Samples = nb::ndarray<const float, nb::ndim<1>, nb::c_contig, nb::device::cpu>;

Samples samplesOf(const ArrayLike& given, const std::string& name) {
    return arrayOf<Samples>(given, "float32", name + ": it is not [frames] of one channel");
}

/// The samples must outlive what is returned.
StrikeRecording recordingOf(const Samples& samples, double rateHz, const std::string& name) {
    if (!(rateHz >= 8000 && rateHz <= 384000))
        throw nb::value_error((name + ": its rate is not between 8000 and 384000 Hz").c_str());
    return {.name = name, .samples = {samples.data(), samples.size()}, .sampleRateHz = rateHz};
}

Material materialOf(const std::variant<Material, std::string>& given) {
    if (const auto* material = std::get_if<Material>(&given))
        return *material;
    return materialNamed(std::get<std::string>(given));
}

std::optional<AnalysisMethod> methodOf(const std::optional<std::string>& name) {
    if (!name)
        return std::nullopt;
    const auto method = findMethod(*name);
    if (!method)
        throw nb::value_error("the method is none of fem, two-layer, spring-mass and van-gelder");
    return method;
}

PythonObject analysed(const Mesh& mesh,
                      const std::variant<Material, std::string>& material,
                      const std::string& name,
                      const std::optional<std::string>& method,
                      double thicknessMetres,
                      double maxFrequencyHz,
                      int elements,
                      const std::vector<std::string>& clamps,
                      const std::optional<double>& supportResistanceNsPerM,
                      bool largestPart,
                      bool allAround,
                      const std::string& radiation,
                      unsigned threads,
                      const Progress& progress) {
    AnalysisSettings settings{.name = name,
                              .source = "Python",
                              .material = materialOf(material),
                              .method = methodOf(method),
                              .thicknessMetres = thicknessMetres,
                              .maxFrequencyHz = maxFrequencyHz,
                              .elementBudget = elements,
                              .largestComponentOnly = largestPart,
                              .threads = threads};
    settings.support.resistanceNsPerM = supportResistanceNsPerM;
    for (const auto& clamp : clamps) {
        auto region = parseClamp(clamp);
        if (!region)
            throw nb::value_error(("the clamp '" + clamp + "' " + region.error().message).c_str());
        settings.support.clamps.push_back(std::move(*region));
    }
    if (allAround)
        settings.listeningDirections = directionsAllAround();
    if (radiation == "none")
        settings.listeningDirections.clear();
    else if (radiation == "exact")
        settings.radiation = RadiationMethod::exact;
    else if (radiation != "quick")
        throw nb::value_error("the radiation is none of none, quick and exact");
    return held(worked(
        progress, [&](const WorkControl& control) { return analyse(mesh, settings, control); }));
}

using Place = std::variant<double, Numbers3>;

PythonObject fitted(const std::vector<std::tuple<ArrayLike, double, Place>>& recordings,
                    const std::string& name,
                    const std::optional<std::variant<Material, std::string>>& material,
                    const std::optional<Mesh>& mesh,
                    const std::optional<double>& massKg,
                    std::size_t modes,
                    double contactSeconds,
                    const Progress& progress) {
    std::vector<Samples> kept;
    std::vector<StrikeRecording> strikes;
    std::vector<StruckPlace> places;
    for (const auto& [samples, rateHz, place] : recordings) {
        const auto recording = "recording " + std::to_string(strikes.size());
        kept.push_back(samplesOf(samples, recording));
        strikes.push_back(recordingOf(kept.back(), rateHz, recording));
        places.push_back(std::holds_alternative<double>(place)
                             ? StruckPlace(std::get<double>(place))
                             : StruckPlace(valuesOf(std::get<Numbers3>(place), "the place")));
    }
    MeasuredObjectSettings settings{.name = name,
                                    .source = "recordings, from Python",
                                    .material = {},
                                    .mesh = mesh,
                                    .massKg = massKg};
    if (material)
        settings.material = materialOf(*material);
    return held(worked(progress, [&](const WorkControl& control) {
        return fitRecordings(strikes, {.modeCount = modes, .contactSeconds = contactSeconds},
                             control)
            .and_then(
                [&](const RecordingFit& fit) { return measuredObject(fit, places, settings); });
    }));
}

std::pair<Material, std::string> recordedMaterial(const ArrayLike& given,
                                                  double sampleRateHz,
                                                  const std::string& name,
                                                  const std::optional<Mesh>& mesh,
                                                  const std::optional<std::string>& method,
                                                  double thicknessMetres,
                                                  const Progress& progress) {
    const auto samples = samplesOf(given, "the recording");
    const auto recording = recordingOf(samples, sampleRateHz, "the recording");
    std::optional<StruckObject> struck;
    if (mesh)
        struck = StruckObject{.name = "the mesh",
                              .mesh = *mesh,
                              .method = methodOf(method),
                              .thicknessMetres = thicknessMetres};
    const auto found = worked(progress, [&](const WorkControl& control) {
        return materialOfRecording(recording, name, struck, control);
    });
    return {found.fit.material, found.findings + (found.notes.empty() ? "" : "\n" + found.notes)};
}

} // namespace

void bindAnalysis(nb::module_& module) {
    const AnalysisSettings defaults;
    module.def(
        "analyse", &analysed, nb::arg("mesh"), nb::arg("material") = "Steel", nb::kw_only(),
        nb::arg("name") = "mesh", nb::arg("method") = nb::none(),
        nb::arg("thickness") = defaults.thicknessMetres,
        nb::arg("max_frequency") = defaults.maxFrequencyHz,
        nb::arg("elements") = defaults.elementBudget,
        nb::arg("clamps") = std::vector<std::string>(), nb::arg("support_resistance") = nb::none(),
        nb::arg("largest_part") = false, nb::arg("all_around") = false,
        nb::arg("radiation") = "quick", nb::arg("threads") = 0, nb::arg("progress") = nb::none(),
        "Makes the modal object of a mesh.\n\n"
        "`material` is a Material or the name of one. `method` is fem, two-layer, "
        "spring-mass or van-gelder; None takes what suits the mesh. `thickness` (m) is of "
        "shells. `max_frequency` is in Hz. `elements` is about the number of tetrahedra of a "
        "solid. `clamps` hold parts of the body, such as \"x<0.02\"; `support_resistance` "
        "(N s/m) says what they take. `largest_part` analyses the largest connected part only. "
        "`radiation` is none, quick or exact: what a World hears at a distance, which takes most "
        "of the time for shells. `all_around` computes it for bodies that turn. `threads` is the "
        "maximum number of cores, 0 for all. `progress(fraction, step)` is called from time to "
        "time. Other Python threads run meanwhile.");
    module.def(
        "fit", &fitted, nb::arg("recordings"), nb::kw_only(), nb::arg("name") = "fit",
        nb::arg("material") = nb::none(), nb::arg("mesh") = nb::none(),
        nb::arg("mass") = nb::none(), nb::arg("modes") = 200, nb::arg("contact_time") = 0.0,
        nb::arg("progress") = nb::none(),
        "Makes a modal object from recordings of single strikes.\n\n"
        "`recordings` are tuples of samples [frames], sample rate (Hz) and the struck place: a "
        "point (x, y, z) in m, or a distance from the z axis. `mesh` is that of the object; "
        "without one it is a surface through the places. `mass` is in kg, `modes` the maximum "
        "number of modes, `contact_time` of the mallet in s, 0 if it is unknown.");
    module.def(
        "material_from_recording", &recordedMaterial, nb::arg("samples"), nb::arg("sample_rate"),
        nb::kw_only(), nb::arg("name") = "Recorded", nb::arg("mesh") = nb::none(),
        nb::arg("method") = nb::none(), nb::arg("thickness") = defaults.thicknessMetres,
        nb::arg("progress") = nb::none(),
        "Finds the material of a struck object from the samples [frames] of a recording.\n\n"
        "With the `mesh` of the object it finds stiffness and damping, without one the damping "
        "alone. `method` and `thickness` are as of `analyse`. Returns the Material, and what was "
        "found in words.");
}

} // namespace idiophone::python
