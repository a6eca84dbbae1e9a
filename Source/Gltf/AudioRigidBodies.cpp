// SPDX-License-Identifier: Apache-2.0
#include "Gltf/AudioRigidBodies.h"

#include "Gltf/GltfAccessor.h"
#include "Gltf/GltfValue.h"
#include "Gltf/PrincipalInertia.h"
#include "Gltf/TinyGltf.h"

#include <algorithm>

namespace idiophone {
namespace {

constexpr const char* extensionName = "KHR_audio_rigid_bodies";
constexpr double huge = 1e300;
constexpr double tiny = 1e-300; ///< for numbers that must be greater than zero

class ModelReader {
public:
    ModelReader(const GltfDocument& document, const GltfValue& model)
        : document_(document), model_(model) {}

    GltfModalModel read(std::size_t materialCount) const {
        GltfModalModel result{.name = model_["name"].text(),
                              .frequenciesHz = column("frequencies"),
                              .decaysPerSecond = column("decayRates"),
                              .positions = floats("positions", 3),
                              .shapes = floats("shapes", 3),
                              .faces = faces(),
                              .material = model_["material"].optionalIndex(materialCount),
                              .mass = mass()};
        check(result);
        readOwnExtension(result);
        return result;
    }

private:
    Eigen::MatrixXd numbers(const char* key, int columns) const {
        auto read = numbersOf(document_, accessor(key), columns);
        if (!read)
            throw GltfValue::Fault{model_[key].place() +
                                   " cannot be read: " + read.error().message};
        return *std::move(read);
    }

    int accessor(const char* key) const {
        return static_cast<int>(model_[key].index(document_.model().accessors.size()));
    }

    int componentType(const char* key) const {
        return document_.model().accessors[static_cast<std::size_t>(accessor(key))].componentType;
    }

    Eigen::MatrixXd floats(const char* key, int columns) const {
        if (componentType(key) != TINYGLTF_COMPONENT_TYPE_FLOAT)
            model_[key].fail("has not the component type FLOAT");
        auto read = numbers(key, columns);
        if (!read.allFinite())
            model_[key].fail("has a number that is not finite");
        return read;
    }

    std::vector<double> column(const char* key) const {
        const auto read = floats(key, 1);
        return {read.data(), read.data() + read.size()};
    }

    Eigen::MatrixXi faces() const {
        const auto key = "indices";
        if (!model_[key].exists())
            return Eigen::MatrixXi(0, 3);
        const int type = componentType(key);
        if (type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT &&
            type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT)
            model_[key].fail("has neither the component type UNSIGNED_INT nor UNSIGNED_SHORT");
        const auto read = numbers(key, 1);
        if (read.size() % 3 != 0)
            model_[key].fail("has a count that is not a multiple of 3");
        Eigen::MatrixXi corners(read.size() / 3, 3);
        for (Eigen::Index corner = 0; corner < read.size(); ++corner)
            corners(corner / 3, corner % 3) = static_cast<int>(
                std::min(read(corner), static_cast<double>(std::numeric_limits<int>::max())));
        return corners;
    }

    std::optional<MassProperties> mass() const {
        const auto read = model_["massProperties"];
        if (!read.exists())
            return {};
        return MassProperties{
            .massKg = read["mass"].number(tiny, huge),
            .centreMetres = read["centerOfMass"].numbers<3>({0, 0, 0}),
            .inertiaKgM2 = inertiaMatrix(
                {.diagonalKgM2 = read["inertiaDiagonal"].numbers<3>({0, 0, 0}),
                 .orientation = read["inertiaOrientation"].numbers<4>({0, 0, 0, 1})})};
    }

    void check(const GltfModalModel& model) const {
        const auto modes = model.modeCount(), points = model.pointCount();
        if (modes == 0 || points == 0)
            model_.fail("has no modes or no sample points");
        if (model.decaysPerSecond.size() != model.frequenciesHz.size())
            model_["decayRates"].fail("has another count than frequencies");
        if (model.shapes.rows() % modes != 0 || model.shapes.rows() / modes != points)
            model_["shapes"].fail("has another count than frequencies times positions");
        if (std::ranges::min(model.frequenciesHz) <= 0)
            model_["frequencies"].fail("has a frequency that is not positive");
        if (std::ranges::min(model.decaysPerSecond) < 0)
            model_["decayRates"].fail("has a negative decay rate");
        if (model.faces.size() > 0 && model.faces.maxCoeff() >= points)
            model_["indices"].fail("names a sample point that does not exist");
    }

    void readOwnExtension(GltfModalModel& result) const {
        const auto own = model_["extensions"]["IDIOPHONE_modal_object"];
        result.objectView = own["object"].optionalIndex(document_.model().bufferViews.size());
        const auto accessors = document_.model().accessors.size();
        const auto accessorOf = [&](const char* key) -> std::optional<int> {
            if (const auto index = own[key].optionalIndex(accessors))
                return static_cast<int>(*index);
            return {};
        };
        result.modesAccessor = accessorOf("modes");
        result.verticesAccessor = accessorOf("vertices");
    }

    const GltfDocument& document_;
    GltfValue model_;
};

GltfAcousticMaterial readMaterial(const GltfValue& material) {
    return {.name = material["name"].text(),
            .densityKgPerM3 = material["density"].optionalNumber(tiny, huge),
            .youngsModulusPa = material["youngsModulus"].optionalNumber(tiny, huge),
            .poissonRatio = material["poissonRatio"].optionalNumber(-1, 0.5),
            .alphaPerSecond = material["alpha"].optionalNumber(0, huge),
            .betaSeconds = material["beta"].optionalNumber(0, huge)};
}

GltfAcousticSurface readSurface(const GltfValue& surface, std::size_t materialCount) {
    const GltfAcousticSurface usual;
    return {.name = surface["name"].text(),
            .roughnessMetres = surface["roughness"].number(usual.roughnessMetres, tiny, huge),
            .correlationLengthMetres =
                surface["correlationLength"].number(usual.correlationLengthMetres, tiny, huge),
            .spectralSlope = surface["spectralSlope"].number(usual.spectralSlope, -huge, 0),
            .material = surface["material"].optionalIndex(materialCount)};
}

GltfAudioNode readNode(const GltfValue& node, const AudioRigidBodies& all) {
    return {.model = node["modalModel"].optionalIndex(all.models.size()),
            .surface = node["acousticSurface"].optionalIndex(all.surfaces.size()),
            .gain = node["gain"].number(1, 0, huge)};
}

} // namespace

bool hasModalModels(const GltfDocument& document) {
    try {
        return GltfValue::extension(document, extensionName)["modalModels"].exists();
    } catch (const GltfValue::Fault&) {
        return true; // the reader says what is broken
    }
}

Result<AudioRigidBodies> audioRigidBodies(const GltfDocument& document) {
    const auto nodeCount = document.model().nodes.size();
    AudioRigidBodies all;
    try {
        const auto root = GltfValue::extension(document, extensionName);
        const auto materials = root["acousticMaterials"], surfaces = root["acousticSurfaces"],
                   models = root["modalModels"];
        for (std::size_t i = 0; i < materials.size(); ++i)
            all.materials.push_back(readMaterial(materials[i]));
        for (std::size_t i = 0; i < surfaces.size(); ++i)
            all.surfaces.push_back(readSurface(surfaces[i], materials.size()));
        for (std::size_t i = 0; i < models.size(); ++i)
            all.models.push_back(ModelReader(document, models[i]).read(materials.size()));
        for (std::size_t i = 0; i < nodeCount; ++i)
            all.nodes.push_back(
                readNode(GltfValue::extensionOfNode(document, i, extensionName), all));
    } catch (const GltfValue::Fault& fault) {
        return failure(fault.sentence);
    }
    return all;
}

} // namespace idiophone
