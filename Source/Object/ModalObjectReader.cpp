// SPDX-License-Identifier: Apache-2.0
#include "Object/ModalObjectBytes.h"

#include "Object/HalfFloat.h"
#include "Object/MaterialJson.h"
#include "Object/OneLine.h"
#include "Object/Safetensors.h"
#include "Object/UntrustedJson.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <nlohmann/json.hpp>

namespace idiophone {
namespace {

using nlohmann::json;
using safetensors::Container;
using safetensors::Fault;
using safetensors::Tensor;

class Reader {
public:
    explicit Reader(Container source) : container(std::move(source)) {
        if (!container.metadata.is_object() || text("format") != "idiophone-modal")
            throw Fault{"it is not an Idiophone modal object"};
        if (text("format_version") != std::to_string(modalFormatVersion))
            throw Fault{"it has format version " + oneLine(text("format_version")) +
                        ", and this Idiophone reads version " + std::to_string(modalFormatVersion)};
    }

    ModalObject object() const {
        ModalObject object;
        object.name = text("name");
        object.method = text("method");
        object.body = body();
        object.thicknessMetres = number(section("geometry"), "thickness_m");
        object.bandHz = number(section("geometry"), "band_hz");
        object.material = material();
        object.mass = massProperties();
        object.provenance = provenance();

        object.eigenvalues = values<double>("eigenvalues", "F64", 1);
        object.shapes = shapes();
        object.shapeVertices = values<std::int32_t>("shape_vertices", "I32", 1);
        object.vertices = values<float>("vertices", "F32", 2);
        object.faces = values<std::int32_t>("faces", "I32", 2);
        if (container.tensors.contains("clamped_vertices"))
            object.clampedVertices = values<std::int32_t>("clamped_vertices", "I32", 1);
        object.bending = optionalValues("bending");
        object.decaysPerSecond = optionalValues("decay_per_s");
        object.extraDecaysPerSecond = optionalValues("extra_decay_per_s");
        if (container.tensors.contains("gains"))
            object.gains = complexValues("gains", 2);
        object.radiation = radiation();
        return object;
    }

private:
    std::string text(const char* key) const {
        if (!container.metadata.contains(key) || !container.metadata[key].is_string())
            throw Fault{"its metadata lack '" + std::string(key) + "'"};
        return container.metadata[key];
    }

    json section(const char* key) const {
        json parsed = parseUntrusted(text(key));
        if (!parsed.is_object())
            throw Fault{"its metadata '" + std::string(key) + "' are not a JSON object"};
        return parsed;
    }

    /// Returns a member that passes `isValid`. `kind` is its article and noun: "the number".
    template <class IsValid>
    static json member(const json& object, const char* key, const char* kind, IsValid isValid) {
        if (!object.contains(key) || !isValid(object[key]))
            throw Fault{std::string("its metadata lack ") + kind + " '" + key + "'"};
        return object[key];
    }

    static double number(const json& object, const char* key) {
        return member(object, key, "the number", [](const json& v) { return v.is_number(); });
    }

    static std::int64_t count(const json& object, const char* key) {
        return member(object, key, "the count", [](const json& v) {
            return v.is_number_unsigned() && v.get<std::uint64_t>() <= std::uint64_t{1} << 53;
        });
    }

    static std::string word(const json& object, const char* key) {
        return member(object, key, "the text", [](const json& v) { return v.is_string(); });
    }

    template <std::size_t size>
    static std::array<double, size> numbers(const json& object, const char* key) {
        return member(object, key, "the numbers", [](const json& v) {
            return v.is_array() && v.size() == size &&
                   std::ranges::all_of(v, [](const json& each) { return each.is_number(); });
        });
    }

    BodyKind body() const {
        const auto kind = text("body");
        if (kind == "solid")
            return BodyKind::solid;
        if (kind == "shell")
            return BodyKind::shell;
        throw Fault{"its body " + inQuotes(kind) + " is neither solid nor shell"};
    }

    Material material() const {
        const auto m = section("material");
        Material material;
        material.name = word(m, "name");
        for (const auto group : materialFigureGroups)
            for (const auto& figure : group)
                figure.of(material) = number(m, figure.key);
        material.source = word(m, "source");
        material.grain = grain(m);
        return material;
    }

    static std::optional<GrainRatios> grain(const json& material) {
        if (!material.contains("grain"))
            return std::nullopt;
        auto ratios = grainFrom(material["grain"]);
        if (!ratios)
            throw Fault{"its material is damaged: " + ratios.error().message};
        return *ratios;
    }

    MassProperties massProperties() const {
        const auto m = section("mass");
        return {.massKg = number(m, "mass_kg"),
                .centreMetres = numbers<3>(m, "centre_m"),
                .inertiaKgM2 = numbers<9>(m, "inertia_kg_m2")};
    }

    Provenance provenance() const {
        const auto p = section("provenance");
        return {.source = word(p, "source"),
                .software = word(p, "software"),
                .notes = word(p, "notes"),
                .analysisSeconds = number(p, "analysis_s"),
                .analysedVertices = count(p, "analysed_vertices"),
                .zeroModes = count(p, "zero_modes")};
    }

    /// If `last` is not 0, the tensor's last dimension must be that.
    const Tensor& tensor(const char* name, std::size_t rank, std::uint64_t last = 0) const {
        const auto found = container.tensors.find(name);
        if (found == container.tensors.end())
            throw Fault{"it lacks the tensor '" + std::string(name) + "'"};
        const auto& shape = found->second.shape;
        if (shape.size() != rank || (last != 0 && shape.back() != last))
            throw Fault{"tensor '" + std::string(name) + "' does not have the right shape"};
        return found->second;
    }

    template <class Value>
    std::vector<Value> values(const char* name, const char* type, std::size_t rank) const {
        const auto& found = tensor(name, rank, rank == 2 ? 3 : 0);
        if (found.type != type)
            throw Fault{"tensor '" + std::string(name) + "' is not of type " + type};
        return found.copy<Value>();
    }

    std::vector<double> optionalValues(const char* name) const {
        if (!container.tensors.contains(name))
            return {};
        return values<double>(name, "F64", 1);
    }

    std::vector<float> shapes() const {
        const auto& found = tensor("shapes", 3, 3);
        // The other tensors' counts are only compared with the product.
        if (found.shape[0] != tensor("shape_vertices", 1).shape[0] ||
            found.shape[1] != tensor("eigenvalues", 1).shape[0])
            throw Fault{"the size of the mode shapes is not vertices x modes x 3"};
        if (found.type == "F32")
            return found.copy<float>();
        if (found.type != "F16")
            throw Fault{"tensor 'shapes' is neither of type F16 nor F32"};
        const auto halves = found.copy<std::uint16_t>();
        std::vector<float> result(halves.size());
        std::ranges::transform(halves, result.begin(), halfToFloat);
        return result;
    }

    /// Reads a tensor of that rank whose last dimension is the real and the imaginary part.
    std::vector<std::complex<float>> complexValues(const char* name, std::size_t rank) const {
        const auto& found = tensor(name, rank);
        if (found.type != "F32" || found.shape.back() != 2)
            throw Fault{std::string("tensor '") + name +
                        "' is not of real and imaginary parts of type F32"};
        const auto parts = found.copy<float>();
        std::vector<std::complex<float>> result;
        for (std::size_t k = 0; k + 1 < parts.size(); k += 2)
            result.emplace_back(parts[k], parts[k + 1]);
        return result;
    }

    RadiationTable radiation() const {
        const auto has = [&](const char* name) { return container.tensors.contains(name); };
        if (!has("radiation") && !has("radiation_directions") && !has("radiation_ratios"))
            return {};
        RadiationTable table;
        table.weights = complexValues("radiation", 4);
        const auto directions = values<float>("radiation_directions", "F32", 2);
        table.frequencyRatios = values<double>("radiation_ratios", "F64", 1);
        for (std::size_t d = 0; d < directions.size(); d += 3)
            table.directions.push_back({directions[d], directions[d + 1], directions[d + 2]});
        const auto& shape = tensor("radiation", 4).shape;
        if (table.weights.empty() || shape[0] != table.directions.size() ||
            shape[1] != table.frequencyRatios.size() ||
            shape[2] != tensor("eigenvalues", 1).shape[0])
            throw Fault{"the size of the radiation is not directions x ratios x modes"};
        return table;
    }

    Container container;
};

} // namespace

Result<ModalObject> readModalObject(std::span<const std::byte> bytes, std::string_view name) {
    const auto refuse = [&](const std::string& sentence) {
        return failure(shownName(name) + ": " + sentence);
    };
    try {
        auto object = validated(Reader(safetensors::parse(bytes)).object());
        if (!object)
            return refuse(object.error().message);
        return object;
    } catch (const Fault& fault) {
        return refuse(fault.sentence);
    } catch (const json::exception&) {
        return refuse("its header is damaged");
    } catch (const std::bad_alloc&) {
        return refuse("it is too large for this machine's memory");
    }
}

} // namespace idiophone
