#include "Benchmarks/RingScene.h"

#include "Analysis/ModalAnalysis.h"
#include "Geometry/ParametricMesh.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace idiophone {
namespace {

// 10 g at 1 m/s for the hardest impact, and the contact time of metal on wood.
constexpr double hardestNewtonSeconds = 0.01;
constexpr double contactSeconds = 0.3e-3;
constexpr double impactRangeDb = 30;

Result<ModalObject> makeRing() {
    return analyse(torusMesh(0.05, 0.006, 20, 10),
                   {.name = "ring",
                    .source = "generated hollow steel ring, radius 50 mm",
                    .material = *findMaterial("Steel"),
                    .method = AnalysisMethod::twoLayer,
                    .thicknessMetres = 0.001,
                    .maxFrequencyHz = 22000});
}

Result<ModalObject> makeTable() {
    return analyse(sheetMesh(1.2, 0.8, 600),
                   {.name = "table",
                    .source = "generated wooden sheet, 1.2 x 0.8 m x 20 mm",
                    .material = *findMaterial("Wood"),
                    .method = AnalysisMethod::twoLayer,
                    .thicknessMetres = 0.020,
                    .maxFrequencyHz = 22000});
}

std::shared_ptr<const ModalObject> undamped(ModalObject object) {
    object.material.damping.fluidPerSecond = 0;
    object.material.damping.viscoelasticSeconds = 0;
    return std::make_shared<const ModalObject>(std::move(object));
}

/// Varies the ring's material: stiffness within 15 %, damping within a factor of two.
ModalObject variedRing(const ModalObject& ring, std::minstd_rand& random) {
    ModalObject varied = ring;
    const double stiffness = 0.85 + 0.30 * share(random);
    varied.material.youngsModulusPa *= stiffness;
    for (auto* values : {&varied.eigenvalues, &varied.bending})
        for (double& value : *values)
            value *= stiffness;
    varied.material.damping.fluidPerSecond *= std::exp2(2 * share(random) - 1);
    varied.material.damping.viscoelasticSeconds *= std::exp2(2 * share(random) - 1);
    return varied;
}

Strike impactOn(const ModalObject& object, double newtonSeconds, std::minstd_rand& random) {
    const std::array place{2 * share(random) - 1, 2 * share(random) - 1, 1.0};
    return strikeInto(strikePointAt(object, place), newtonSeconds, contactSeconds);
}

} // namespace

Result<RingScene> makeRingScene() {
    auto ring = makeRing();
    auto table = makeTable();
    if (!ring)
        return tl::unexpected(ring.error());
    if (!table)
        return tl::unexpected(table.error());

    RingScene scene{.ringVertices = ring->vertexCount(), .tableVertices = table->vertexCount()};
    std::minstd_rand random(2006);
    for (std::size_t k = 0; k < ringCount; ++k) {
        const ModalObject varied = variedRing(*ring, random);
        scene.slots.push_back({std::make_shared<const ModalObject>(varied)});
        scene.undampedSlots.push_back({undamped(varied)});
    }
    scene.slots.push_back({std::make_shared<const ModalObject>(*table)});
    scene.undampedSlots.push_back({undamped(*table)});

    for (std::size_t k = 0; k < ringCount; ++k) {
        const double seconds =
            ringStrikeSeconds * (static_cast<double>(k) + share(random)) / ringCount;
        const double newtonSeconds =
            hardestNewtonSeconds * std::pow(10.0, -impactRangeDb / 20 * share(random));
        scene.strikes.push_back(
            {seconds, k, impactOn(*scene.slots[k].object, newtonSeconds, random)});
        if (k % 5 == 0) // the others fall on rings
            scene.strikes.push_back({seconds, ringCount, impactOn(*table, newtonSeconds, random)});
    }
    return scene;
}

std::vector<ModalPole> audiblePoles(const ModalObject& object) {
    std::vector<ModalPole> poles;
    for (const double eigenvalue : object.eigenvalues) {
        const ModalPole pole{eigenvalue, 0};
        const double hz = naturalFrequencyHz(pole);
        if (hz >= 20 && hz < 0.49 * benchSampleRateHz)
            poles.push_back(pole);
    }
    return poles;
}

std::vector<ModalPole> polesOfEveryMode(const ModalObject& object) {
    const auto audible = audiblePoles(object);
    std::vector<ModalPole> poles;
    for (std::size_t i = 0; i < 3 * object.vertexCount(); ++i)
        poles.push_back(audible[i % audible.size()]);
    return poles;
}

} // namespace idiophone
