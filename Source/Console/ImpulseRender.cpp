#include "Console/ImpulseRender.h"

#include "Console/AssignedEffect.h"
#include "Console/ImpulseFile.h"
#include "Console/RenderLoop.h"
#include "Instrument/FactoryContent.h"
#include "Instrument/Instrument.h"
#include "Instrument/ObjectLibrary.h"
#include "Instrument/SettingsOfParameters.h"
#include "Object/FileBytes.h"
#include "Object/OneLine.h"
#include "World/World.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <map>
#include <optional>
#include <utility>

namespace idiophone {
namespace {

struct ImpulseScore {
    std::vector<SynthesiserSlot> bodies;
    std::vector<WorldImpact> impacts; ///< in order of time
};

/// Resolves an object's file relative to the list of impulses.
std::string resolved(const std::string& object, const std::filesystem::path& impulseFile) {
    if (factoryObject(object))
        return object;
    return storedNameOf(impulseFile.parent_path() / pathNamed(localName(object)));
}

/// An object named by impulses.
struct StruckObject {
    Result<std::shared_ptr<const ModalObject>> object;
    int firstLine = 0; ///< first line that names the object
};

Eigen::Vector3d vectorOf(const std::array<double, 3>& numbers) {
    return Eigen::Vector3d(numbers.data());
}

Result<ImpulseScore> arrange(std::span<const Impulse> impulses,
                             const std::filesystem::path& file,
                             const std::filesystem::path& output) {
    ImpulseScore score;
    BadLines faults;
    std::map<std::string, StruckObject> objects;
    std::map<std::pair<std::string, std::string>, std::size_t> numberOfBody;
    for (const auto& impulse : impulses) {
        auto known = objects.find(impulse.object);
        if (known == objects.end())
            known =
                objects
                    .emplace(impulse.object, StruckObject{.object = ObjectLibrary::shared().find(
                                                              resolved(impulse.object, file))})
                    .first;
        auto& struck = known->second;
        if (struck.firstLine == 0 || impulse.line < struck.firstLine)
            struck.firstLine = impulse.line;
        if (!struck.object)
            continue;
        const auto [body, isNew] =
            numberOfBody.try_emplace({impulse.object, impulse.body}, score.bodies.size());
        if (isNew)
            score.bodies.push_back({.object = *struck.object, .sizeRatio = impulse.sizeRatio});
        else if (score.bodies[body->second].sizeRatio != impulse.sizeRatio) {
            faults.add(impulse.line,
                       "its 'size' differs from that of earlier lines of the same body");
            continue;
        }
        if (impulse.vertex &&
            !std::ranges::binary_search((*struck.object)->shapeVertices, *impulse.vertex)) {
            faults.add(impulse.line, "vertex " + std::to_string(*impulse.vertex) + " of " +
                                         inQuotes(impulse.object) + " has no mode shapes");
            continue;
        }
        score.impacts.push_back({.body = body->second,
                                 .seconds = impulse.seconds,
                                 .vertex = impulse.vertex,
                                 .pointMetres = impulse.sizeRatio * vectorOf(impulse.pointMetres),
                                 .impulseNewtonSeconds = vectorOf(impulse.impulseNewtonSeconds),
                                 .contactSeconds = impulse.contactSeconds});
    }
    std::error_code fault;
    for (const auto& [name, struck] : objects)
        if (!struck.object)
            faults.add(struck.firstLine, struck.object.error().message);
        else if (!factoryObject(name) &&
                 std::filesystem::equivalent(pathNamed(localName(resolved(name, file))), output,
                                             fault))
            faults.add(struck.firstLine, inQuotes(name) + " is the output file");
    if (!faults.empty())
        return tl::unexpected(faults.error(file));
    if (auto bounded = boundedSlots(score.bodies, nameOf(file), "bodies"); !bounded)
        return tl::unexpected(bounded.error());
    return score;
}

/// Renders cells in order, and tells the world of the impacts before each.
class CellPlayer {
public:
    CellPlayer(std::span<const WorldImpact> all, std::unique_ptr<World> played)
        : impacts(all), world(std::move(played)) {}

    /// Advances by a cell and returns it. The result is valid until the next call.
    StereoSpan next(RenderTally& tally) {
        const auto start = std::chrono::steady_clock::now();
        const double end = world->seconds() + cellSamples / world->sampleRateHz();
        while (due < impacts.size() && impacts[due].seconds < end &&
               world->strike(impacts[due]) != WorldAnswer::busy)
            ++due;
        world->render(left, right);
        tally.renderSeconds +=
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        tally.strikes = static_cast<std::int64_t>(due) - world->impactsLeftOut();
        tally.count(world->modesMixed());
        return {left, right};
    }

    bool finished() const { return due == impacts.size() && world->silent(); }
    void warnOfLeftOut(const std::filesystem::path& file) const {
        if (world->impactsLeftOut() > 0)
            std::cerr << "warning: " << nameOf(file) << ": " << world->impactsLeftOut()
                      << " impulses were left out, because they are too hard for such light objects"
                      << std::endl;
    }

private:
    std::span<const WorldImpact> impacts;
    std::unique_ptr<World> world;
    std::array<float, cellSamples> left{}, right{};
    std::size_t due = 0;
};

} // namespace

Result<RenderTally> renderImpulses(const std::filesystem::path& file,
                                   const ParameterValues& parameters,
                                   std::span<const ParameterId> assigned,
                                   Recording& recording) {
    const auto impulses = readImpulses(file);
    if (!impulses)
        return tl::unexpected(impulses.error());
    const auto score = arrange(*impulses, file, recording.format.file);
    if (!score)
        return tl::unexpected(score.error());

    RenderTally tally;
    const auto effect =
        assignedEffect(parameters, assigned, {.by = PlayedBy::impulses, .slots = score->bodies});
    print(effect.warnings);
    const double rate = recording.format.sampleRateHz;
    auto world = World::make(score->bodies, {.sampleRateHz = rate,
                                             .listener = {},
                                             .eventCapacity = 65536,
                                             .synthesis = synthesisSettings(effect.values)});
    if (!world)
        return tl::unexpected(world.error());
    CellPlayer player(score->impacts, std::move(*world));
    return renderTo(recording,
                    {.name = nameOf(file.filename()),
                     .lastSample = static_cast<std::int64_t>(score->impacts.back().seconds * rate),
                     .pieceSamples = cellSamples,
                     .render =
                         [&](std::int64_t count) {
                             return player.next(tally).subspan(0, static_cast<std::size_t>(count));
                         },
                     .finished = [&] { return player.finished(); }})
        .map([&] {
            player.warnOfLeftOut(file);
            return tally;
        });
}

} // namespace idiophone
