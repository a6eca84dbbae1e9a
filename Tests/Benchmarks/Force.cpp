#include "Benchmarks/Benchmarks.h"
#include "Benchmarks/Timer.h"
#include "Synth/ContactForce.h"

#include <algorithm>
#include <array>
#include <benchmark/benchmark.h>
#include <random>
#include <utility>

namespace idiophone {
namespace {

constexpr std::array<std::size_t, 3> sizes{100, 500, 1000};
constexpr std::size_t pathPoints = 61; ///< of a closed path
constexpr std::size_t cellsBetweenPoints = 8;
constexpr std::size_t forceCells = 32; ///< of noise, repeated

using Cell = std::array<float, cellSamples>;

/// Returns points inside triangles of vertices with shapes. Neighbouring points differ.
std::vector<ForcePoint> pathOver(const ModalObject& object) {
    const auto rows = static_cast<std::int32_t>(object.shapeVertexCount());
    std::vector<ForcePoint> points;
    for (std::int32_t k = 0; k < static_cast<std::int32_t>(pathPoints); ++k) {
        const float way = static_cast<float>(k % 4 + 1) / 6;
        points.push_back(
            {.point = {.shapeRows = {k / 4 % rows, (k / 4 + 1) % rows, (k / 4 + 2) % rows},
                       .weights = {0.8f - way, way, 0.2f},
                       .normal = {0, 0, 1}}});
    }
    return points;
}

/// One object with all modes ringing: free, or under a fixed or moving force.
class ForcedObject {
public:
    enum class Contact { none, stays, moves };

    ForcedObject(const std::shared_ptr<const ModalObject>& object, Contact contact)
        : synth({{object}}, benchSampleRateHz), path(pathOver(*object)), touched(contact) {
        // Undamped, so that it rings for any number of timed cells.
        const Material& own = object->material;
        synth.setSettings(
            {.tau = 0,
             .compression = 0,
             .material = LiveMaterial{.youngsModulusPa = own.youngsModulusPa,
                                      .densityKgPerM3 = own.densityKgPerM3,
                                      .damping = {.fluidPerSecond = 0, .viscoelasticSeconds = 0}}});
        std::mt19937 random(1);
        for (Cell& newtons : forces)
            for (float& newton : newtons)
                newton = static_cast<float>(random()) / 2147483648.0f - 1;
        synth.beginCell(cell);
        synth.strike(0, strikeInto(path[0].point, 1, 0), 0, cell);
    }

    void nextCell() {
        synth.beginCell(cell);
        if (touched != Contact::none) {
            const ForcePlace from = placeNow();
            if (touched == Contact::moves)
                ++cellsMoved;
            count = (count + 1) % forces.size();
            synth.applyForce(0, {.start = from, .end = placeNow(), .newtons = forces[count]}, cell);
        }
        benchmark::DoNotOptimize(cell);
    }

    std::int64_t modesMixed() const { return synth.modesMixed(); }

private:
    ForcePlace placeNow() const {
        const std::size_t point = cellsMoved / cellsBetweenPoints;
        return {.points = {path[point % path.size()], path[(point + 1) % path.size()]},
                .fraction =
                    static_cast<float>(cellsMoved % cellsBetweenPoints) / cellsBetweenPoints};
    }

    Synthesiser synth;
    std::vector<ForcePoint> path;
    Contact touched;
    std::array<Cell, forceCells> forces{};
    std::size_t cellsMoved = 0;
    std::size_t count = 0;
    alignas(64) Cell cell{};
};

/// The three cases of one size, measured side by side.
struct SizeContest {
    ForcedObject free, staying, moving;

    explicit SizeContest(const std::shared_ptr<const ModalObject>& object)
        : free(object, ForcedObject::Contact::none), staying(object, ForcedObject::Contact::stays),
          moving(object, ForcedObject::Contact::moves) {}

    std::int64_t fewestModesMixed() const {
        return std::min({free.modesMixed(), staying.modesMixed(), moving.modesMixed()});
    }
};

/// A generator of contact force, without an object.
struct Generator {
    const char* name;
    ContactForce force;

    Generator(const char* called,
              const std::shared_ptr<const SurfaceProfile>& profile,
              const ContactForceSettings& settings)
        : name(called), force(profile, 1) {
        std::array<CoupledMode, ContactForce::maxCoupledModes> modes;
        for (std::size_t i = 0; i < modes.size(); ++i)
            modes[i] = {.frequencyHz = 300.0 * static_cast<double>(i + 1), .dampingPerSecond = 5};
        force.setCoupledModes(modes);
        force.setSettings(settings);
    }

    void nextCell() {
        alignas(64) Cell newtons;
        force.render({.speedMetresPerSecond = 0.5, .normalForceNewtons = 5}, newtons);
        benchmark::DoNotOptimize(newtons);
    }
};

std::vector<Generator> generators() {
    const auto profile = std::make_shared<const SurfaceProfile>(Surface{}, benchSampleRateHz, 1);
    return {{"scrape", profile, {}},
            {"roll", profile, {.kind = ContactKind::roll}},
            {"coupled roll", profile, {.kind = ContactKind::roll, .rollModalCoupling = 1}}};
}

void report(BenchSection& section, std::size_t modes, std::span<const double, 3> seconds) {
    const double staying = seconds[1] / seconds[0];
    const double moving = seconds[2] / seconds[0];
    section.row(std::to_string(modes) + " modes",
                "free " + figure(seconds[0] * 1e6) + " us a cell; under a force that stays " +
                    figure(staying) + ", that moves " + figure(moving) + " times that");
    section.figures["sizes"].push_back({{"modes", modes},
                                        {"free_s", seconds[0]},
                                        {"staying_s", seconds[1]},
                                        {"moving_s", seconds[2]},
                                        {"staying_over_free", staying},
                                        {"moving_over_free", moving}});
    if (modes < 500)
        return;
    for (const auto& [how, ratio] : {std::pair("staying", staying), std::pair("moving", moving)})
        section.goals.push_back(
            {"force: cost over the free bank at " + std::to_string(modes) + " modes, " + how, ratio,
             BenchGoal::Kind::atMost, 2.5});
}

} // namespace

Result<BenchSection> benchForce(const BenchContent& content) {
    const auto bars = objectsNamed(content, "xylophone-");
    if (!bars)
        return tl::unexpected(bars.error());
    std::vector<std::unique_ptr<SizeContest>> contests;
    std::vector<Contestant> contestants;
    for (const std::size_t modes : sizes) {
        auto* contest = contests
                            .emplace_back(std::make_unique<SizeContest>(
                                longRingingObject(*bars->front(), modes, 10)))
                            .get();
        contestants.push_back([contest] { contest->free.nextCell(); });
        contestants.push_back([contest] { contest->staying.nextCell(); });
        contestants.push_back([contest] { contest->moving.nextCell(); });
    }
    auto sources = generators();
    for (Generator& source : sources)
        contestants.push_back([&source] { source.nextCell(); });
    const auto seconds = leastSeconds(contestants);

    BenchSection section{.name = "force",
                         .title = "one ringing object, mono, cells of 64 samples: under continuous "
                                  "force against free; what makes the force, apart"};
    for (std::size_t k = 0; k < sizes.size(); ++k) {
        const auto mixed = contests[k]->fewestModesMixed();
        if (mixed != static_cast<std::int64_t>(sizes[k]))
            return failure("The force benchmark mixes only " + std::to_string(mixed) + " of " +
                           std::to_string(sizes[k]) + " modes.");
        report(section, sizes[k], std::span(seconds).subspan(3 * k).first<3>());
    }
    const double free500 = seconds[3];
    for (std::size_t k = 0; k < sources.size(); ++k) {
        const double own = seconds[3 * sizes.size() + k];
        section.row(std::string("making the force of a ") + sources[k].name,
                    figure(own * 1e6) + " us a cell, " + figure(own / free500) +
                        " of a free cell of 500 modes");
        section.figures["generators"].push_back(
            {{"name", sources[k].name}, {"seconds", own}, {"over_free_500", own / free500}});
    }
    return section;
}

} // namespace idiophone
