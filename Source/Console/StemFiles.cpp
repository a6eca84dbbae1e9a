#include "Console/StemFiles.h"
#include "Object/FileBytes.h"

#include <algorithm>
#include <utility>

namespace idiophone {
namespace {

bool sounds(const StereoSpan& stem) {
    const auto isSound = [](float sample) { return sample != 0; };
    return std::ranges::any_of(stem.left, isSound) || std::ranges::any_of(stem.right, isSound);
}

} // namespace

StemFiles::StemFiles(std::filesystem::path destination,
                     std::vector<std::string> namesOfStems,
                     const RecordingFormat& formatOfMix,
                     const ParameterValues& values)
    : folder(std::move(destination)), names(std::move(namesOfStems)), format(formatOfMix),
      parameters(values), recordings(names.size()) {
    parameters.set(ParameterId::limiter, 0);
}

/// Starts the stem's file with the silence up to here.
Result<void> StemFiles::begin(std::size_t stem) {
    auto own = format;
    own.file = folder / pathNamed(names[stem]).concat(format.file.extension().native());
    auto recording = Recording::start(own, parameters);
    if (!recording)
        return tl::unexpected(recording.error());
    recordings[stem] = std::move(*recording);
    const std::vector<float> silence(samplesBefore);
    return recordings[stem]->addAll(silence, silence);
}

Result<void> StemFiles::add(std::span<const StereoSpan> stems, std::size_t sampleCount) {
    for (std::size_t stem = 0; stem < recordings.size(); ++stem) {
        const auto piece = stems[stem].subspan(0, sampleCount);
        if (recordings[stem] == nullptr && sounds(piece))
            if (auto begun = begin(stem); !begun)
                return begun;
        if (recordings[stem] != nullptr)
            if (auto added = recordings[stem]->addAll(piece.left, piece.right); !added)
                return added;
    }
    samplesBefore += sampleCount;
    return {};
}

Result<void> StemFiles::finish(std::int64_t samples) {
    for (const auto& recording : recordings)
        if (recording != nullptr)
            if (auto finished = recording->finish(samples); !finished)
                return finished;
    return {};
}

nlohmann::ordered_json StemFiles::statistics() const {
    auto files = nlohmann::ordered_json::array();
    for (const auto& recording : recordings)
        if (recording != nullptr) {
            auto figures = recording->statistics();
            figures["file"] = nameOf(recording->format.file);
            files.push_back(std::move(figures));
        }
    return files;
}

} // namespace idiophone
