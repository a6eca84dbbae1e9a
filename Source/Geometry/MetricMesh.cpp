#include "Geometry/MetricMesh.h"

#include "Object/OneLine.h"

#include <utility>

namespace idiophone {
namespace {

Result<UnitGuess> unitOf(const MeshOfFile& file, const std::optional<std::string>& named) {
    if (!named) {
        UnitGuess guess = guessLengthUnit(file.mesh, file.isInMetres);
        if (guess.isSure && guess.unit.metresPerUnit == 1)
            guess.sentence.clear();
        return guess;
    }
    const auto unit = lengthUnitNamed(*named);
    if (!unit)
        return failure(inQuotes(*named) + " is no unit of length: use m, cm, mm, in or ft");
    return UnitGuess{.unit = *unit, .isSure = true, .sentence = {}};
}

} // namespace

Result<MetricMesh> readMetricMesh(const std::filesystem::path& file,
                                  const std::optional<std::string>& unit) {
    auto read = readMeshFile(file);
    if (!read)
        return tl::unexpected(read.error());
    const auto guess = unitOf(*read, unit);
    if (!guess)
        return tl::unexpected(guess.error());
    read->mesh.vertices *= guess->unit.metresPerUnit;
    return MetricMesh{.mesh = std::move(read->mesh),
                      .notes = std::move(read->notes),
                      .unitSentence = guess->sentence,
                      .groups = std::move(read->groups)};
}

} // namespace idiophone
