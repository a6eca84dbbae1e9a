#include "Console/ImpulseRender.h"

#include "Console/AssignedEffect.h"
#include "Console/ImpulseFile.h"
#include "Console/RenderLoop.h"
#include "Instrument/FactoryContent.h"
#include "Instrument/Instrument.h"
#include "Instrument/ObjectLibrary.h"
#include "Instrument/ObjectSurface.h"
#include "Instrument/SettingsOfParameters.h"
#include "Object/FileBytes.h"
#include "Object/OneLine.h"
#include "Synth/Synthesiser.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <map>
#include <optional>
#include <utility>

namespace idiophone {
namespace {

struct Contact {
    double seconds = 0;
    std::size_t slot = 0;
    Strike strike;
};

struct ImpulseScore {
    std::vector<SynthesiserSlot> slots;
    std::vector<Contact> contacts; ///< in order of time
};

/// Resolves an object's file relative to the list of impulses.
std::string resolved(const std::string& object, const std::filesystem::path& impulseFile) {
    if (factoryObject(object))
        return object;
    return storedNameOf(impulseFile.parent_path() / pathNamed(localName(object)));
}

/// An object named by impulses, and its surface.
struct StruckObject {
    Result<std::shared_ptr<const ModalObject>> object;
    std::shared_ptr<const ObjectSurface> surface; ///< null if there is no object
    int firstLine = 0;                            ///< first line that names the object
};

/// One surface for each object, even if it has several names.
using Surfaces = std::map<const ModalObject*, std::shared_ptr<const ObjectSurface>>;

StruckObject struckObject(const std::string& object, Surfaces& surfaces) {
    StruckObject struck{.object = ObjectLibrary::shared().find(object), .surface = {}};
    if (struck.object) {
        auto& surface = surfaces[struck.object->get()];
        if (surface == nullptr)
            surface = std::make_shared<ObjectSurface>(**struck.object);
        struck.surface = surface;
    }
    return struck;
}

Result<ImpulseScore> arrange(std::span<const Impulse> impulses,
                             const std::filesystem::path& file,
                             const std::filesystem::path& output) {
    ImpulseScore score;
    BadLines faults;
    std::map<std::string, StruckObject> objects;
    Surfaces surfaces;
    std::map<std::pair<std::string, std::string>, std::size_t> slotOfBody;
    for (const auto& impulse : impulses) {
        auto known = objects.find(impulse.object);
        if (known == objects.end())
            known =
                objects
                    .emplace(impulse.object, struckObject(resolved(impulse.object, file), surfaces))
                    .first;
        auto& struck = known->second;
        if (struck.firstLine == 0 || impulse.line < struck.firstLine)
            struck.firstLine = impulse.line;
        if (!struck.object)
            continue;
        const auto [body, isNew] =
            slotOfBody.try_emplace({impulse.object, impulse.body}, score.slots.size());
        if (isNew)
            score.slots.push_back({.object = *struck.object, .sizeRatio = impulse.sizeRatio});
        else if (score.slots[body->second].sizeRatio != impulse.sizeRatio) {
            faults.add(impulse.line,
                       "its 'size' differs from that of earlier lines of the same body");
            continue;
        }

        const auto point = impulse.vertex ? struck.surface->atVertex(*impulse.vertex)
                                          : struck.surface->nearest(impulse.pointMetres);
        if (!point) {
            faults.add(impulse.line, "vertex " + std::to_string(*impulse.vertex) + " of " +
                                         inQuotes(impulse.object) + " has no mode shapes");
            continue;
        }
        Contact contact{.seconds = impulse.seconds, .slot = body->second, .strike = {}};
        contact.strike.point = *point;
        contact.strike.durationSeconds = impulse.contactSeconds;
        std::ranges::transform(impulse.impulseNewtonSeconds,
                               contact.strike.impulseNewtonSeconds.begin(),
                               [](double component) { return static_cast<float>(component); });
        score.contacts.push_back(contact);
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
    if (auto bounded = boundedSlots(score.slots, file.string(), "bodies"); !bounded)
        return tl::unexpected(bounded.error());
    return score;
}

/// Renders cells in order, each with the contacts that begin within it.
class CellPlayer {
public:
    CellPlayer(const ImpulseScore& score, const SynthesisSettings& settings, double sampleRateHz)
        : contacts(score.contacts), synth(score.slots, sampleRateHz, 2) {
        synth.setSettings(settings);
    }

    /// Advances by a cell and returns it. The result is valid until the next call.
    StereoSpan next(RenderTally& tally) {
        const CellOutput cell(left, right);
        const auto start = std::chrono::steady_clock::now();
        synth.beginCell(cell);
        for (; due < contacts.size(); ++due) {
            const double sample = contacts[due].seconds * synth.sampleRateHz() - cellStart;
            if (sample >= cellSamples)
                break;
            const bool taken =
                synth.strike(contacts[due].slot, contacts[due].strike, std::max(sample, 0.0), cell);
            if (taken)
                ++tally.strikes;
            else
                ++(synth.contactsUsedUp(contacts[due].slot) ? crowdedOut : beyondReason);
        }
        cellStart += cellSamples;
        tally.renderSeconds +=
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        tally.count(synth.modesMixed());
        return {left, right};
    }

    bool finished() const { return due == contacts.size() && synth.silent(); }
    void warnOfLeftOut(const std::filesystem::path& file) const {
        for (const auto& [count, why] :
             {std::pair{crowdedOut, "their bodies already had 64 contacts"},
              std::pair{beyondReason, "they are too hard for such light objects"}})
            if (count > 0)
                std::cerr << "warning: " << file.string() << ": " << count
                          << " impulses were left out, because " << why << std::endl;
    }

private:
    std::span<const Contact> contacts;
    Synthesiser synth;
    alignas(64) std::array<float, cellSamples> left{}, right{};
    double cellStart = 0;
    std::size_t due = 0;
    std::int64_t crowdedOut = 0, beyondReason = 0;
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
        assignedEffect(parameters, assigned, {.by = PlayedBy::impulses, .slots = score->slots});
    print(effect.warnings);
    const double rate = recording.format.sampleRateHz;
    CellPlayer player(*score, synthesisSettings(effect.values), rate);
    return renderTo(recording,
                    {.name = file.filename().string(),
                     .lastSample = static_cast<std::int64_t>(score->contacts.back().seconds * rate),
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
