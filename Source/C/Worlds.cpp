// SPDX-License-Identifier: Apache-2.0
#include "C/Handles.h"

#include <Eigen/Geometry>
#include <array>
#include <span>
#include <vector>

using namespace idiophone;
using namespace idiophone::c;

namespace {

/// Does what a call says; what cannot be done for lack of memory must wait.
template <class Act>
idiophone_result answer(Act act) noexcept {
    try {
        switch (act()) {
        case WorldAnswer::done:
            return IDIOPHONE_DONE;
        case WorldAnswer::busy:
            return IDIOPHONE_BUSY;
        case WorldAnswer::invalid:
            break;
        }
        return IDIOPHONE_INVALID;
    } catch (const std::exception&) {
        return IDIOPHONE_BUSY;
    }
}

Eigen::Vector3d vector(const float values[3]) {
    return Eigen::Vector3f(values).cast<double>();
}

Surface surfaceOf(const idiophone_surface& given) {
    return {.spectrumExponent = given.spectrum_exponent,
            .resonFrequencyHz = given.frequency,
            .resonDampingPerSecond = given.damping,
            .referenceSpeedMetresPerSecond = given.reference_speed,
            .slowestSpeedMetresPerSecond = given.slowest_speed,
            .roughness = given.roughness};
}

/// Returns the elements of an array whose structures have the size that the first one names.
template <class Structure>
std::vector<Structure> readAll(const Structure* first, std::size_t count, Structure defaults) {
    std::vector<Structure> all;
    if (first == nullptr)
        return all;
    const auto* bytes = reinterpret_cast<const std::byte*>(first);
    for (std::size_t k = 0; k < count; ++k)
        all.push_back(
            read(reinterpret_cast<const Structure*>(bytes + k * first->struct_size), defaults));
    return all;
}

Result<idiophone_world*> makeWorld(const idiophone_body* bodies,
                                   std::size_t bodyCount,
                                   const idiophone_world_settings* given) {
    const auto settings = read(given, idiophone_world_settings(IDIOPHONE_WORLD_SETTINGS_DEFAULTS));
    WorldSettings wanted{.sampleRateHz = settings.sample_rate,
                         .eventCapacity = settings.event_capacity};
    if (settings.without_listener != 0)
        wanted.listener.reset();
    if (settings.surface_count > 0)
        wanted.surfaces.clear();
    for (const auto& surface : readAll(settings.surfaces, settings.surface_count,
                                       idiophone_surface(IDIOPHONE_SURFACE_DEFAULTS)))
        wanted.surfaces.push_back(surfaceOf(surface));
    std::vector<SynthesiserSlot> slots;
    for (const auto& body : readAll(bodies, bodyCount, idiophone_body(IDIOPHONE_BODY_DEFAULTS)))
        slots.push_back({.object = body.object == nullptr ? nullptr : body.object->object,
                         .sizeRatio = body.size});
    auto world = World::make(std::move(slots), wanted);
    if (!world)
        return tl::unexpected(world.error());
    return new idiophone_world{std::move(*world)};
}

} // namespace

idiophone_world* idiophone_world_create(const idiophone_body* bodies,
                                        size_t body_count,
                                        const idiophone_world_settings* settings) {
    return orNull([=] { return makeWorld(bodies, body_count, settings); });
}

void idiophone_world_free(idiophone_world* world) {
    delete world;
}

double idiophone_world_seconds(const idiophone_world* world) {
    return world->world->seconds();
}

idiophone_result idiophone_world_place(idiophone_world* world,
                                       size_t body,
                                       const float position[3],
                                       const float rotation[4]) {
    return answer([=] {
        if (position == nullptr)
            return WorldAnswer::invalid;
        WorldPose pose{.originMetres = vector(position)};
        if (rotation != nullptr)
            pose.axes = Eigen::Quaternionf(rotation).cast<double>().toRotationMatrix();
        return world->world->place(body, pose);
    });
}

idiophone_result idiophone_world_listen(idiophone_world* world,
                                        const float position[3],
                                        const float ahead[3],
                                        const float up[3]) {
    return answer([=] {
        if (position == nullptr || ahead == nullptr || up == nullptr)
            return WorldAnswer::invalid;
        return world->world->placeListener({.positionMetres = vector(position),
                                            .towardsMetres = vector(position) + vector(ahead),
                                            .up = vector(up)});
    });
}

idiophone_result idiophone_world_strike(idiophone_world* world, const idiophone_impact* impact) {
    return answer([=] {
        if (impact == nullptr)
            return WorldAnswer::invalid;
        const auto hit = read(impact, idiophone_impact(IDIOPHONE_IMPACT_DEFAULTS));
        return world->world->strike({.body = hit.body,
                                     .seconds = hit.time,
                                     .pointMetres = vector(hit.point),
                                     .impulseNewtonSeconds = vector(hit.impulse),
                                     .contactSeconds = hit.contact_time});
    });
}

idiophone_result idiophone_world_begin_touch(idiophone_world* world, size_t* touch) {
    return answer([=] {
        if (touch == nullptr)
            return WorldAnswer::invalid;
        const auto free = world->world->beginTouch();
        *touch = free.value_or(*touch);
        return free ? WorldAnswer::done : WorldAnswer::busy;
    });
}

idiophone_result
idiophone_world_touch(idiophone_world* world, size_t touch, const idiophone_contact* contact) {
    return answer([=] {
        if (contact == nullptr)
            return WorldAnswer::invalid;
        const auto now = read(contact, idiophone_contact(IDIOPHONE_CONTACT_DEFAULTS));
        WorldTouch wanted{.body = now.body,
                          .pointMetres = vector(now.point),
                          .forceNewtons = now.force,
                          .slideMetresPerSecond = vector(now.slide_velocity),
                          .rollMetresPerSecond = now.roll_speed,
                          .surface = now.surface};
        if (now.other_body != IDIOPHONE_NO_BODY)
            wanted.other = now.other_body;
        return world->world->touch(touch, wanted);
    });
}

idiophone_result idiophone_world_end_touch(idiophone_world* world, size_t touch) {
    return answer([=] { return world->world->endTouch(touch); });
}

idiophone_result idiophone_world_set_material(idiophone_world* world,
                                              size_t body,
                                              const idiophone_material* material) {
    return answer([=] {
        if (material == nullptr)
            return world->world->setMaterial(body, std::nullopt);
        const auto given = read(material, idiophone_material(IDIOPHONE_MATERIAL_DEFAULTS));
        return world->world->setMaterial(
            body, LiveMaterial{.youngsModulusPa = given.youngs_modulus,
                               .densityKgPerM3 = given.density,
                               .damping = {.fluidPerSecond = given.damping_fluid,
                                           .viscoelasticSeconds = given.damping_viscoelastic,
                                           .lossFactor = given.damping_loss_factor}});
    });
}

idiophone_result idiophone_world_set_damping(idiophone_world* world, size_t body, double rate) {
    return answer([=] { return world->world->setDamping(body, rate); });
}

idiophone_result idiophone_world_set_quality(idiophone_world* world,
                                             const idiophone_quality* quality) {
    return answer([=] {
        if (quality == nullptr)
            return WorldAnswer::invalid;
        const auto given = read(quality, idiophone_quality(IDIOPHONE_QUALITY_DEFAULTS));
        SynthesisSettings wanted = world->world->synthesis();
        wanted.tau = given.truncation;
        wanted.qualitySlope = given.slope;
        wanted.modeBudget = given.mode_budget;
        wanted.compression = given.compression;
        return world->world->setSynthesis(wanted);
    });
}

idiophone_result idiophone_world_set_gain(idiophone_world* world, double gain) {
    return answer([=] { return world->world->setGain(gain); });
}

void idiophone_world_render(
    idiophone_world* world, float* left, float* right, size_t frame_count, size_t stride) {
    std::array<float, 256> leftEar, rightEar;
    for (std::size_t done = 0; done < frame_count;) {
        const std::size_t count = std::min(frame_count - done, leftEar.size());
        world->world->render(std::span(leftEar).first(count), std::span(rightEar).first(count));
        for (std::size_t k = 0; k < count; ++k, ++done) {
            left[done * stride] = leftEar[k];
            right[done * stride] = rightEar[k];
        }
    }
}

int idiophone_world_silent(const idiophone_world* world) {
    return world->world->silent() ? 1 : 0;
}
