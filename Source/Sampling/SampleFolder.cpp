#include "Sampling/SampleFolder.h"

#include "Object/FileBytes.h"
#include "Object/FileName.h"
#include "Object/NumberText.h"
#include "Object/TextFile.h"
#include "Sampling/SfzText.h"

namespace idiophone {
namespace {

std::string
sfzOf(const SampleTask& task, const SampleExportSettings& settings, double gainDecibels) {
    const auto& sampled = task.sampled;
    SfzInstrument sfz{.name = sampled.preset.name,
                      .folder = "",
                      .ending = task.ending,
                      .gainDecibels = gainDecibels,
                      .tailDecibels = settings.tailDecibels,
                      .keysHavePitches = sampled.preset.keyMap.kind != KeyMapKind::zones,
                      .releaseSeconds = {}};
    if (sampled.values[ParameterId::letRing] == 0)
        sfz.releaseSeconds = sampled.values[ParameterId::releaseTime];
    return sfzText(sfz, task.keys);
}

std::string tableOf(const SampleTask& task, const std::vector<SampleFigures>& figures) {
    std::string table = "file,x_m,y_m,z_m,velocity,peak_dbfs,loudest_moment_lufs,seconds\n";
    for (std::size_t i = 0; i < figures.size(); ++i) {
        const auto& place = task.places[i];
        table += place.name + task.ending;
        for (const double metres : place.placeMetres)
            table += "," + numberText(metres + 0.0); // no "-0"
        table += "," + std::to_string(place.strike.velocity);
        for (const double figure :
             {figures[i].peakDecibels, figures[i].loudestMomentLufs, figures[i].seconds})
            table += "," + numberText(figure);
        table += "\n";
    }
    return table;
}

} // namespace

Result<SampleFolder> exportTask(const SampleTask& task,
                                const SampleExportSettings& settings,
                                WorkTeam& team,
                                const WorkControl& control) {
    const auto jobs = task.jobsIn(settings.folder);
    const auto exported = exportSamples(task.sampled, jobs, settings, team, control);
    if (!exported)
        return tl::unexpected(exported.error());
    SampleFolder folder{.exported = *exported, .index = {}};
    std::string text;
    if (task.places.empty()) {
        const auto& name = task.sampled.preset.name;
        folder.index =
            settings.folder / pathNamed(fileNameFrom(name.empty() ? "Instrument" : name) + ".sfz");
        text = sfzOf(task, settings, exported->gainDecibels);
    } else {
        auto figures = figuresOf(jobs, control);
        if (!figures)
            return tl::unexpected(figures.error());
        folder.figures = std::move(*figures);
        folder.index = settings.folder / "samples.csv";
        text = tableOf(task, folder.figures);
    }
    return writeTextFile(folder.index, text).map([&] { return folder; });
}

bool holdsSamples(const std::filesystem::path& folder) {
    std::error_code ignored;
    return std::filesystem::exists(folder / sampleRecordName, ignored);
}

} // namespace idiophone
