#include "Plugin/FinishedObject.h"

#include "Analysis/MeasuredObject.h"
#include "AudioFiles/AudioFileReader.h"
#include "Editor/Utf8.h"
#include "Gltf/ObjectFile.h"
#include "Plugin/FileKinds.h"

#include <array>

namespace idiophone {
namespace {

std::string stemOf(const std::filesystem::path& file) {
    return textOf(file.stem()).toStdString();
}

Result<ModalObject> fromModal(const std::filesystem::path& file) {
    auto object = readObject(file);
    if (!object)
        return object;
    if (object->modeCount() == 0 || object->shapeVertexCount() == 0 || object->faceCount() == 0)
        return failure(fileNameOf(file) + ": it has no mode, or no surface to be struck.");
    if (object->name.empty())
        object->name = stemOf(file);
    return object;
}

Result<ModalObject> fromRecording(const std::filesystem::path& file, const WorkControl& control) {
    const auto recording = readRecording(file);
    if (!recording)
        return tl::unexpected(recording.error());
    const auto fit =
        fitRecordings(std::array{StrikeRecording{.name = fileNameOf(file),
                                                 .samples = recording->samples,
                                                 .sampleRateHz = recording->sampleRateHz}},
                      {}, control);
    if (!fit)
        return tl::unexpected(fit.error());
    const std::array places{StruckPlace(0.0)}; // the middle of a disc
    auto object = measuredObject(*fit, places,
                                 {.name = stemOf(file),
                                  .source = fileNameOf(file),
                                  .material = {},
                                  .mesh = {},
                                  .massKg = {}});
    if (object) {
        auto& notes = object->provenance.notes;
        notes = fit->rests.front().sentence();
        for (const auto& remark : fit->remarks)
            notes += ' ' + remark;
    }
    return object;
}

} // namespace

Result<ModalObject> finishedObject(const std::filesystem::path& file, const WorkControl& control) {
    control.report(0, "Reading");
    return matches(file, recordingFiles) ? fromRecording(file, control) : fromModal(file);
}

} // namespace idiophone
