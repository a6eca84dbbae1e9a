// SPDX-License-Identifier: Apache-2.0
#include "Gltf/GltfObject.h"

#include "Gltf/OwnObject.h"
#include "Gltf/RigidBodies.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <new>
#include <numbers>
#include <numeric>

namespace idiophone {
namespace {

/// How loud every model is, in Pa·m for a modal acceleration of 1 m/s² √kg. The draft leaves this
/// to us, but demands one factor for all models. With this one, its samples' bar of ceramic, 240 ×
/// 60 × 20 mm, radiates at 2 kHz what the draft's section "Radiation and Distance" says.
constexpr double pressurePerAcceleration = 0.001;
/// The decay of a mode that has none in the file.
constexpr double slowestDecayPerSecond = 1e-3;
constexpr const char* usualMaterial = "Steel";

/// A finish of the draft's Authoring Notes.
struct Finish {
    double roughness; ///< 0 to 1
    double roughnessMetres, correlationLengthMetres, spectralSlope;
};
constexpr std::array<Finish, 4> finishes{{{0, 1e-7, 1e-5, -2.8},
                                          {1.0 / 3, 2e-6, 5e-5, -2.4},
                                          {2.0 / 3, 1e-5, 1e-4, -2.2},
                                          {1, 1e-4, 1e-3, -2.0}}};

double logarithmicBetween(double from, double to, double share) {
    return from * std::pow(to / from, share);
}

/// Returns the order in which the eigenvalues ascend.
std::vector<std::size_t> ascendingOrder(const std::vector<double>& values) {
    std::vector<std::size_t> order(values.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return values[i]; });
    return order;
}

double eigenvalueOf(double frequencyHz, double decayPerSecond) {
    const double omega = 2 * std::numbers::pi * frequencyHz;
    return omega * omega + decayPerSecond * decayPerSecond;
}

/// Returns the loss factor that is the median of all modes'.
DampingLaw lawOfDecays(const GltfModalModel& model) {
    std::vector<double> lossFactors;
    for (std::size_t mode = 0; mode < model.frequenciesHz.size(); ++mode)
        lossFactors.push_back(
            2 * std::max(model.decaysPerSecond[mode], slowestDecayPerSecond) /
            std::sqrt(eigenvalueOf(model.frequenciesHz[mode], model.decaysPerSecond[mode])));
    const auto middle = lossFactors.begin() + static_cast<std::ptrdiff_t>(lossFactors.size() / 2);
    std::ranges::nth_element(lossFactors, middle);
    return {.lossFactor = *middle};
}

bool hasDampingLaw(const GltfAcousticMaterial& given) {
    return given.alphaPerSecond.value_or(0) > 0 || given.betaSeconds.value_or(0) > 0;
}

/// `hasLaw`: the file says how the material damps. Otherwise the decays do not depend on the size.
void addModes(ModalObject& object, const GltfModalModel& model, bool hasLaw, double sizeRatio) {
    constexpr double floatError = 1e-5; // of the file's numbers, generously
    const auto modes = model.frequenciesHz.size();
    std::vector<double> eigenvalues(modes), decays(modes);
    bool isLaw = hasLaw;
    for (std::size_t mode = 0; mode < modes; ++mode) {
        const double decay = std::max(model.decaysPerSecond[mode], slowestDecayPerSecond);
        const double unscaled = eigenvalueOf(model.frequenciesHz[mode], decay);
        const double byLaw = object.material.damping.perSecond(unscaled) / 2;
        isLaw = isLaw && std::abs(decay - byLaw) <= floatError * byLaw;
        eigenvalues[mode] = unscaled / (sizeRatio * sizeRatio);
        const double scaledByLaw = object.material.damping.perSecond(eigenvalues[mode]) / 2;
        decays[mode] = hasLaw ? decay * scaledByLaw / byLaw : decay;
    }
    const auto order = ascendingOrder(eigenvalues);
    const double shapeRatio = std::pow(sizeRatio, -1.5);
    const auto points = static_cast<std::size_t>(model.pointCount());
    object.shapes.resize(points * modes * 3);
    for (std::size_t mode = 0; mode < modes; ++mode) {
        object.eigenvalues.push_back(eigenvalues[order[mode]]);
        if (!isLaw)
            object.decaysPerSecond.push_back(decays[order[mode]]);
        for (std::size_t point = 0; point < points; ++point)
            for (std::size_t axis = 0; axis < 3; ++axis)
                object.shapes[(point * modes + mode) * 3 + axis] = static_cast<float>(
                    shapeRatio *
                    model.shapes(static_cast<Eigen::Index>(order[mode] * points + point),
                                 static_cast<Eigen::Index>(axis)));
    }
    object.bandHz = object.dampedFrequencyHz(modes - 1);
}

void addSurface(ModalObject& object, const GltfModalModel& model, double sizeRatio) {
    for (Eigen::Index point = 0; point < model.pointCount(); ++point) {
        for (Eigen::Index axis = 0; axis < 3; ++axis)
            object.vertices.push_back(static_cast<float>(sizeRatio * model.positions(point, axis)));
        object.shapeVertices.push_back(static_cast<std::int32_t>(point));
    }
    for (const auto face : model.faces.rowwise())
        object.faces.insert(object.faces.end(), face.begin(), face.end());
}

/// Returns the mass of a body without a given one. A mode of mass 1 moves with the mean square
/// 1/mass.
MassProperties guessedMass(const ModalObject& object) {
    double squares = 0;
    for (const double square : summedSquareShapes(object))
        squares += square;
    const double mean =
        squares / static_cast<double>(object.modeCount() * object.shapeVertexCount());
    return {.massKg = mean > 0 ? 1 / mean : 1};
}

MassProperties scaledMass(const MassProperties& mass, double sizeRatio) {
    MassProperties scaled = mass;
    scaled.massKg *= std::pow(sizeRatio, 3);
    for (double& metres : scaled.centreMetres)
        metres *= sizeRatio;
    for (double& moment : scaled.inertiaKgM2)
        moment *= std::pow(sizeRatio, 5);
    return scaled;
}

void addMass(ModalObject& object, const GltfModalModel& model, const GltfInstance& instance) {
    constexpr std::int64_t rigidModes = 6;
    if (!instance.mass && !model.mass) {
        object.mass = guessedMass(object);
        return;
    }
    object.mass = instance.mass ? *instance.mass : scaledMass(*model.mass, instance.scale);
    object.provenance.zeroModes = rigidModes; // of a free body, which clicks when it is struck
}

/// The draft's radiation factor 2πf, for the sine that follows an impulse.
void addRadiation(ModalObject& object, double gain) {
    // A live material shifts the modes. Between two ratios, the interpolation is within 0.5 dB.
    constexpr int octaves = 3;
    auto& table = object.radiation;
    table.directions = {{-0.1f, 0.76849f, 0.632f}, {0.1f, 0.76849f, 0.632f}}; // y points up
    for (int octave = -octaves; octave <= octaves; ++octave)
        table.frequencyRatios.push_back(std::exp2(octave));
    for (std::size_t direction = 0; direction < table.directions.size(); ++direction)
        for (const double ratio : table.frequencyRatios)
            for (std::size_t mode = 0; mode < object.modeCount(); ++mode) {
                const double omega = 2 * std::numbers::pi * object.dampedFrequencyHz(mode);
                // The modal velocity is that of (1 + i d/ω) e^{iωt}; the pressure is that of a
                // sine.
                const std::complex<double> velocity(1, object.decayPerSecond(mode) / omega);
                table.weights.emplace_back(std::complex<double>(0, -1) / velocity * gain * ratio *
                                           omega * pressurePerAcceleration);
            }
}

/// Returns sentences about what else is in the file; may be empty.
std::string notesOn(const GltfDocument& document, const AudioRigidBodies& audio) {
    std::string notes;
    if (audio.models.size() > 1)
        notes =
            "The first of " + std::to_string(audio.models.size()) + " modal models in its file.";
    if (hasRigidBodies(document))
        notes += (notes.empty() ? "" : " ") +
                 std::string("The file has rigid bodies: it is a scene, too (docs/gltf.md).");
    return notes;
}

Result<ModalObject> firstObjectIn(const GltfDocument& document) {
    const auto audio = audioRigidBodies(document);
    if (!audio)
        return failure(audio.error().message);
    if (audio->models.empty())
        return failure("it has no modal model (KHR_audio_rigid_bodies)");
    GltfInstance instance;
    for (const auto& node : audio->nodes)
        if (node.model == 0) {
            instance.surface = node.surface;
            break;
        }
    return objectOf(document, *audio, 0, instance).map([&](ModalObject&& object) {
        if (const auto notes = notesOn(document, *audio); !notes.empty())
            object.provenance.notes = notes;
        return std::move(object);
    });
}

} // namespace

Material materialOf(const GltfAcousticMaterial& given) {
    const auto* named = findMaterial(given.name);
    Material material = named != nullptr ? *named : *findMaterial(usualMaterial);
    material.name = given.name;
    material.source = "a glTF file";
    material.grain = {};
    material.densityKgPerM3 = given.densityKgPerM3.value_or(material.densityKgPerM3);
    material.youngsModulusPa = given.youngsModulusPa.value_or(material.youngsModulusPa);
    material.poissonRatio =
        std::clamp(given.poissonRatio.value_or(material.poissonRatio), -0.999, 0.4999);
    if (hasDampingLaw(given))
        material.damping = {.fluidPerSecond = given.alphaPerSecond.value_or(0),
                            .viscoelasticSeconds = given.betaSeconds.value_or(0)};
    return material;
}

Result<ModalObject> objectOf(const GltfDocument& document,
                             const AudioRigidBodies& audio,
                             std::size_t number,
                             const GltfInstance& instance) {
    const auto& model = audio.models[number];
    if (instance.gain == 1 && instance.scale == 1 && !instance.mass)
        if (auto own = ownObject(document, model))
            return *std::move(own);
    if (model.frequenciesHz.size() > maximumObjectModes)
        return failure("a model has more than " + std::to_string(maximumObjectModes) + " modes");
    ModalObject object;
    object.name = model.name.empty() ? "model " + std::to_string(number + 1) : model.name;
    object.method = "glTF";
    const auto& given = model.material ? audio.materials[*model.material] : GltfAcousticMaterial{};
    object.material = materialOf(given);
    if (!hasDampingLaw(given))
        object.material.damping = lawOfDecays(model);
    if (object.material.name.empty())
        object.material.name = object.name;
    if (instance.surface)
        object.material.roughness = roughnessOf(audio.surfaces[*instance.surface]);
    addModes(object, model, hasDampingLaw(given), instance.isRetuned ? instance.scale : 1);
    addSurface(object, model, instance.scale);
    addMass(object, model, instance);
    addRadiation(object, instance.gain);
    return validated(std::move(object));
}

Result<ModalObject> firstObjectOf(std::string_view bytes, const GltfBufferReader& readBuffer) {
    try {
        return GltfDocument::parse(bytes, readBuffer).and_then(firstObjectIn);
    } catch (const std::bad_alloc&) {
        return failure("it is too large for this machine's memory");
    }
}

double roughnessOf(const GltfAcousticSurface& surface) {
    for (std::size_t next = 1; next < finishes.size(); ++next) {
        const auto &from = finishes[next - 1], &to = finishes[next];
        if (surface.roughnessMetres > to.roughnessMetres && next + 1 < finishes.size())
            continue;
        const double share = std::log(surface.roughnessMetres / from.roughnessMetres) /
                             std::log(to.roughnessMetres / from.roughnessMetres);
        return std::clamp(std::lerp(from.roughness, to.roughness, share), 0.0, 1.0);
    }
    return 1;
}

GltfAcousticSurface surfaceOf(double roughness) {
    const double place = std::clamp(roughness, 0.0, 1.0) * (finishes.size() - 1);
    const auto index = std::min(static_cast<std::size_t>(place), finishes.size() - 2);
    const double share = place - static_cast<double>(index);
    const auto &from = finishes[index], &to = finishes[index + 1];
    return {.name = {},
            .roughnessMetres = logarithmicBetween(from.roughnessMetres, to.roughnessMetres, share),
            .correlationLengthMetres =
                logarithmicBetween(from.correlationLengthMetres, to.correlationLengthMetres, share),
            .spectralSlope = std::lerp(from.spectralSlope, to.spectralSlope, share),
            .material = {}};
}

} // namespace idiophone
