#include "Analysis/BarTuning.h"

#include "Analysis/BodyModel.h"
#include "Analysis/Eigensolver.h"
#include "Analysis/HeldBody.h"
#include "Analysis/QuadraticTetrahedra.h"
#include "Analysis/TubeMouth.h"
#include "Mesh/ObjectMesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace idiophone {
namespace {

constexpr int maximumCorrections = 10;

BodyModel bodyOf(const BarSpecification& bar, const UndercutBar& shape, const SolidBar& solid) {
    BodyModel body;
    if (bar.held)
        body.support = supportOf(*bar.held, shape);
    body.surface = solid.surface;
    body.model =
        quadraticTetrahedra(solid.elements, elasticLaw(bar.material), bar.material.densityKgPerM3);
    body.pointsMetres = solid.elements.nodes;
    body.body = BodyKind::solid;
    body.material = bar.material;
    body.method = "fem";
    return body;
}

/// A mode bends vertically if most motion of the top is vertical and equal across the width.
/// `motionAt` takes a vertex index of the outline.
template <class MotionAt>
bool bendsVertically(int topCount, const MotionAt& motionAt) {
    constexpr std::array<double, BarOutline::topAcross> weights{0.25, 0.5, 0.25};
    double together = 0, all = 0;
    const int lines = topCount / BarOutline::topAcross;
    for (int line = 0; line < lines; ++line) {
        double mean = 0;
        for (int j = 0; j < BarOutline::topAcross; ++j) {
            const auto weight = weights[j];
            const Eigen::Vector3d motion = motionAt(j * lines + line);
            mean += weight * motion.z();
            all += weight * motion.squaredNorm();
        }
        together += mean * mean;
    }
    return together > 0.5 * all;
}

bool haveSameShape(const ModalObject& object, std::size_t a, std::size_t b) {
    for (std::size_t row = 0; row < object.shapeVertexCount(); ++row)
        if (!std::ranges::equal(object.shapesAt(row).subspan(3 * a, 3),
                                object.shapesAt(row).subspan(3 * b, 3)))
            return false;
    return true;
}

double targetHz(const PartialTargets& targets, int partial) {
    const std::array ratios{1.0, targets.secondRatio, targets.thirdRatio};
    return targets.fundamentalHz * ratios[partial];
}

/// Returns the lowest bending partials, as many as there are targets.
Result<std::vector<double>> lowestPartialsHz(const BarSpecification& bar,
                                             const UndercutBar& shape,
                                             const WorkControl& control) {
    const int count = bar.targets.count();
    const SolidBar solid = solidBar(shape);
    const auto body = bodyOf(bar, shape, solid);
    const auto held = heldRows(body);
    if (!held)
        return failure(held.error().message);
    const auto modes = solveHeldModes(
        body.model, *held, {.highestHz = 1.3 * targetHz(bar.targets, count - 1)}, control.quiet());
    if (!modes)
        return failure(modes.error().message);
    std::vector<double> partials;
    const BarOutline& outline = solid.outline;
    for (Eigen::Index mode = 0; mode < modes->eigenvalues.size(); ++mode)
        if (bendsVertically(outline.topCount, [&](std::size_t place) {
                return modes->shapes.col(mode).segment<3>(3 * outline.surfaceVertices[place]);
            }))
            partials.push_back(dampedFrequencyHz(modes->eigenvalues(mode), bar.material));
    if (static_cast<int>(partials.size()) < count)
        return failure("the partials asked for do not bend up and down");
    return partials;
}

/// Corrects the beam's targets by the error that the elements show. Returns false if all partials
/// are within tolerance.
bool correct(const PartialTargets& targets,
             const std::vector<double>& partialsHz,
             PartialTargets& asked) {
    bool isMet = std::abs(cents(partialsHz[0], targets.fundamentalHz)) < fundamentalToleranceCents;
    asked.fundamentalHz *= targets.fundamentalHz / partialsHz[0];
    const auto correctRatio = [&](int partial, double wanted, double& ratio) {
        const double found = partialsHz[partial];
        isMet = isMet && std::abs(cents(found, targetHz(targets, partial))) < partialToleranceCents;
        ratio *= wanted / (found / partialsHz[0]);
    };
    if (targets.secondRatio > 0)
        correctRatio(1, targets.secondRatio, asked.secondRatio);
    if (targets.thirdRatio > 0)
        correctRatio(2, targets.thirdRatio, asked.thirdRatio);
    return !isMet;
}

/// Replaces the object's mesh by the outline. The shapes belong to the top vertices.
Result<ModalObject> withOutline(ModalObject object, const BarOutline& outline) {
    setMesh(object, outline.mesh);
    for (std::size_t k = 0; k < object.shapeVertices.size(); ++k)
        object.shapeVertices[k] = static_cast<std::int32_t>(k);
    const auto held = std::exchange(object.clampedVertices, {});
    for (std::size_t k = 0; k < outline.surfaceVertices.size(); ++k)
        if (std::ranges::binary_search(held, outline.surfaceVertices[k]))
            object.clampedVertices.push_back(static_cast<std::int32_t>(k));
    return validated(std::move(object));
}

std::array<double, 3> fromCentre(const Eigen::Vector3d& point, const ModalObject& object) {
    const auto& centre = object.mass.centreMetres;
    return {point.x() - centre[0], point.y() - centre[1], point.z() - centre[2]};
}

Result<TunedBar>
analysed(const BarSpecification& bar, const UndercutBar& shape, const WorkControl& control) {
    const SolidBar solid = solidBar(shape);
    const auto top = solid.outline.surfaceVertices.begin();
    const Eigen::Vector3d mouth =
        bar.tube ? mouthMetres(shape, *bar.tube) : Eigen::Vector3d::Zero();
    Eigen::MatrixXcd mouthPressures;
    auto object =
        solveBody(bodyOf(bar, shape, solid),
                  {.name = bar.name,
                   .source = bar.source,
                   .maxFrequencyHz = bar.maxFrequencyHz,
                   .shapeVertices = {top, top + solid.outline.topCount},
                   .radiation = RadiationMethod::exact,
                   .nearPointsMetres = bar.tube ? mouthPoints(mouth, bar.tube->radiusMetres)
                                                : std::vector<Eigen::Vector3d>{}},
                  control, &mouthPressures);
    if (!object)
        return failure(object.error().message);
    TunedBar result{.shape = shape, .surface = solid.surface};
    for (const auto mode : verticalBendingModes(*object))
        result.partialsHz.push_back(object->dampedFrequencyHz(mode));
    if (bar.cords)
        addCordLoss(*object, *bar.cords);
    if (bar.tube)
        addTube(
            *object, *bar.tube,
            mouthKgPerM2(blockedOverFree(shape, *bar.tube), mouthPressures, object->eigenvalues),
            fromCentre(mouth, *object));
    result.bendingModes = verticalBendingModes(*object);
    auto light = withOutline(std::move(*object), solid.outline);
    if (!light)
        return failure(light.error().message);
    result.object = std::move(*light);
    return result;
}

/// The length of a uniform Euler–Bernoulli bar of the target pitch, reduced by the effect of the
/// arch.
double estimatedLengthMetres(const BarSpecification& bar) {
    const double speed = std::sqrt(bar.material.youngsModulusPa / bar.material.densityKgPerM3);
    const double share = bar.targets.secondRatio == 0    ? 0.9
                         : bar.targets.secondRatio < 3.5 ? 0.75
                                                         : 0.35;
    return std::sqrt(1.02792 * bar.shape.heightMetres * speed * share / bar.targets.fundamentalHz);
}

/// Tunes the length of a bar that is held at one end.
Result<TunedBar> tuneHeld(const BarSpecification& bar, const WorkControl& control) {
    if (bar.targets.count() > 1)
        return failure("a bar that is held at one end has only its fundamental tuned");
    UndercutBar shape = bar.shape;
    if (shape.lengthMetres == 0)
        shape.lengthMetres = estimatedLengthMetres(*bar.held, shape, beamMaterial(bar.material),
                                                   bar.targets.fundamentalHz);
    for (int step = 0; step < maximumCorrections; ++step) {
        control.report(0.06 * step, "Tuning the bar");
        shape = withBridge(shape, *bar.held);
        const auto partials = lowestPartialsHz(bar, shape, control);
        if (!partials)
            return failure(partials.error().message);
        const double ratio = partials->front() / bar.targets.fundamentalHz;
        if (std::abs(cents(partials->front(), bar.targets.fundamentalHz)) <
            fundamentalToleranceCents)
            return analysed(bar, shape, control);
        shape.lengthMetres *= std::sqrt(ratio);
    }
    return failure("its fundamental does not settle");
}

Result<TunedBar> tune(const BarSpecification& bar, const WorkControl& control) {
    if (const auto material = validated(bar.material); !material)
        return failure(material.error().message);
    if (!(bar.targets.fundamentalHz >= 20) ||
        !(targetHz(bar.targets, bar.targets.count() - 1) * 1.3 <= bar.maxFrequencyHz))
        return failure("its partials must lie between 20 Hz and three quarters of its band");
    if (bar.held)
        return tuneHeld(bar, control);
    UndercutBar shape = bar.shape;
    if (shape.lengthMetres == 0)
        shape.lengthMetres = estimatedLengthMetres(bar);
    PartialTargets asked = bar.targets;
    for (int step = 0; step < maximumCorrections; ++step) {
        control.report(0.06 * step, "Tuning the bar");
        const auto arch = tunedArch(shape, beamMaterial(bar.material), asked);
        if (!arch)
            return failure(arch.error().message);
        shape = *arch;
        const auto partials = lowestPartialsHz(bar, shape, control);
        if (!partials)
            return failure(partials.error().message);
        if (!correct(bar.targets, *partials, asked))
            return analysed(bar, shape, control);
    }
    return failure("its partials do not settle");
}

} // namespace

std::vector<Eigen::Index> verticalBendingModes(const ModalObject& bar) {
    std::vector<Eigen::Index> bending;
    const auto gain = [&](std::size_t mode) {
        return bar.gains.empty() ? 1.0f : std::abs(bar.gains[mode]);
    };
    for (std::size_t mode = 0; mode < bar.modeCount(); ++mode) {
        if (!bendsVertically(static_cast<int>(bar.shapeVertexCount()), [&](std::size_t row) {
                const auto shape = bar.shapesAt(row).subspan(3 * mode, 3);
                return Eigen::Vector3d(shape[0], shape[1], shape[2]);
            }))
            continue;
        if (bending.empty() || !haveSameShape(bar, bending.back(), mode))
            bending.push_back(mode);
        else if (gain(mode) > gain(bending.back()))
            bending.back() = static_cast<Eigen::Index>(mode);
    }
    return bending;
}

BeamMaterial beamMaterial(const Material& material) {
    const double y = material.youngsModulusPa, nu = material.poissonRatio;
    return {.youngsModulusPa = y,
            .shearModulusPa =
                material.grain ? y * material.grain->shearModulusLR : y / (2 * (1 + nu)),
            .shearCoefficient = rectangularShearCoefficient(nu),
            .densityKgPerM3 = material.densityKgPerM3};
}

Result<TunedBar> tuneBar(const BarSpecification& bar, const WorkControl& control) {
    return tune(bar, control).map_error([&](Error fault) {
        if (!isCancellation(fault))
            fault.message = "The bar \"" + bar.name + "\" cannot be tuned: " + fault.message;
        return fault;
    });
}

} // namespace idiophone
