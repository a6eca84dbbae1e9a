// SPDX-License-Identifier: Apache-2.0
#include "Object/HalfFloat.h"
#include "Object/MaterialJson.h"
#include "Object/ModalObjectBytes.h"
#include "Object/Safetensors.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace idiophone {
namespace {

using nlohmann::json;

json describeMetadata(const ModalObject& object) {
    const json geometry{{"thickness_m", object.thicknessMetres}, {"band_hz", object.bandHz}};
    const json mass{{"mass_kg", object.mass.massKg},
                    {"centre_m", object.mass.centreMetres},
                    {"inertia_kg_m2", object.mass.inertiaKgM2}};
    const json provenance{
        {"source", object.provenance.source},
        {"software", object.provenance.software},
        {"notes", object.provenance.notes},
        {"analysis_s", object.provenance.analysisSeconds},
        {"analysed_vertices", static_cast<std::uint64_t>(object.provenance.analysedVertices)},
        {"zero_modes", static_cast<std::uint64_t>(object.provenance.zeroModes)}};
    // Metadata of safetensors maps texts to texts, so it contains JSON as text. Names come from
    // people and files: replace invalid UTF-8.
    const auto inner = [](const json& section) {
        return section.dump(-1, ' ', false, json::error_handler_t::replace);
    };
    return {{"format", "idiophone-modal"},
            {"format_version", std::to_string(modalFormatVersion)},
            {"units", "SI: metres, kilograms, seconds, pascals; eigenvalues in rad²/s²"},
            {"name", object.name},
            {"method", object.method},
            {"body", object.body == BodyKind::shell ? "shell" : "solid"},
            {"geometry", inner(geometry)},
            {"material", inner(materialJson<json>(object.material))},
            {"mass", inner(mass)},
            {"provenance", inner(provenance)}};
}

} // namespace

std::vector<std::byte> encodeModalObject(const ModalObject& object, ShapePrecision precision) {
    safetensors::Writer writer(describeMetadata(object));
    const auto modes = object.modeCount();
    const auto shapeVertices = object.shapeVertexCount();
    // Write the widest numbers first, so that every tensor is aligned to the size of its numbers.
    writer.add("eigenvalues", "F64", {modes}, object.eigenvalues);
    const auto addIfAny = [&](const char* name, const std::vector<double>& values) {
        if (!values.empty())
            writer.add(name, "F64", {modes}, values);
    };
    addIfAny("bending", object.bending);
    addIfAny("decay_per_s", object.decaysPerSecond);
    addIfAny("extra_decay_per_s", object.extraDecaysPerSecond);
    const auto& radiation = object.radiation;
    const auto directions = radiation.directions.size(), ratios = radiation.frequencyRatios.size();
    if (!radiation.empty())
        writer.add("radiation_ratios", "F64", {ratios}, radiation.frequencyRatios);
    writer.add("vertices", "F32", {object.vertexCount(), 3}, object.vertices);
    if (!radiation.empty()) {
        writer.add("radiation_directions", "F32", {directions, 3}, radiation.directions);
        writer.add("radiation", "F32", {directions, ratios, modes, 2}, radiation.weights);
    }
    if (!object.gains.empty())
        writer.add("gains", "F32", {modes, 2}, object.gains);
    writer.add("faces", "I32", {object.faceCount(), 3}, object.faces);
    writer.add("shape_vertices", "I32", {shapeVertices}, object.shapeVertices);
    if (const auto clamped = object.clampedVertices.size(); clamped > 0)
        writer.add("clamped_vertices", "I32", {clamped}, object.clampedVertices);
    const bool fitsHalf = std::ranges::all_of(
        object.shapes, [](float shape) { return std::isfinite(halfToFloat(floatToHalf(shape))); });
    if (precision == ShapePrecision::single || !fitsHalf) {
        writer.add("shapes", "F32", {shapeVertices, modes, 3}, object.shapes);
    } else {
        std::vector<std::uint16_t> halves(object.shapes.size());
        std::ranges::transform(object.shapes, halves.begin(), floatToHalf);
        writer.add("shapes", "F16", {shapeVertices, modes, 3}, halves);
    }
    return writer.finish();
}

} // namespace idiophone
