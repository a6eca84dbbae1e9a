// SPDX-License-Identifier: Apache-2.0
#include "C/Handles.h"
#include "Gltf/ObjectBytes.h"

#include <span>

using namespace idiophone;
using namespace idiophone::c;

uint32_t idiophone_interface_version(void) {
    return IDIOPHONE_INTERFACE_VERSION;
}

const char* idiophone_error(void) {
    return lastError().c_str();
}

idiophone_object* idiophone_object_read(const void* bytes, size_t byte_count, const char* name) {
    return orNull([=]() -> Result<idiophone_object*> {
        if (bytes == nullptr)
            return failure("no bytes are given");
        return readObject(std::span(static_cast<const std::byte*>(bytes), byte_count),
                          name == nullptr ? "object" : name)
            .map(handleOf);
    });
}

void idiophone_object_free(idiophone_object* object) {
    delete object;
}

const char* idiophone_object_name(const idiophone_object* object) {
    return object->object->name.c_str();
}

double idiophone_object_mass(const idiophone_object* object) {
    return object->object->mass.massKg;
}

void idiophone_object_box(const idiophone_object* object, float low[3], float high[3]) {
    const auto& vertices = object->object->vertices;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        low[axis] = high[axis] = vertices.empty() ? 0 : vertices[axis];
        for (std::size_t k = axis; k < vertices.size(); k += 3) {
            low[axis] = std::min(low[axis], vertices[k]);
            high[axis] = std::max(high[axis], vertices[k]);
        }
    }
}

size_t idiophone_object_mode_count(const idiophone_object* object) {
    return object->object->modeCount();
}

size_t idiophone_object_modes(const idiophone_object* object,
                              double* frequencies,
                              double* decay_rates,
                              size_t capacity) {
    const auto& modal = *object->object;
    const std::size_t count = std::min(capacity, modal.modeCount());
    for (std::size_t mode = 0; mode < count; ++mode) {
        if (frequencies != nullptr)
            frequencies[mode] = modal.dampedFrequencyHz(mode);
        if (decay_rates != nullptr)
            decay_rates[mode] = modal.decayPerSecond(mode);
    }
    return count;
}

idiophone_result idiophone_material_named(const char* name, idiophone_material* material) {
    const auto* known = name == nullptr ? nullptr : findMaterial(name);
    if (known == nullptr || material == nullptr)
        return IDIOPHONE_INVALID;
    idiophone_material found = IDIOPHONE_MATERIAL_DEFAULTS;
    found.youngs_modulus = known->youngsModulusPa;
    found.density = known->densityKgPerM3;
    found.damping_fluid = known->damping.fluidPerSecond;
    found.damping_viscoelastic = known->damping.viscoelasticSeconds;
    found.damping_loss_factor = known->damping.lossFactor;
    found.struct_size = std::min<uint32_t>(material->struct_size, sizeof found);
    std::memcpy(material, &found, found.struct_size);
    return IDIOPHONE_DONE;
}
