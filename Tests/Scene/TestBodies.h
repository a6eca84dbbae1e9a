// Bodies of known mass and form for tests.
#pragma once

#include "Geometry/ParametricMesh.h"
#include "Mesh/ObjectMesh.h"
#include "Scene/RigidWorld.h"

#include <cmath>
#include <numbers>

namespace idiophone::test {

inline constexpr double gravity = 9.81;

inline std::shared_ptr<ModalObject> objectOf(const Mesh& mesh, const char* material) {
    auto object = std::make_shared<ModalObject>();
    object->name = "body";
    object->material = *findMaterial(material);
    setMesh(*object, mesh);
    return object;
}

struct Contactful {
    double friction = 0.5, restitution = 0.5, rollingFriction = 0;
};

inline RigidWorld::Kind
kindOf(const std::shared_ptr<ModalObject>& object, BodyForm form, bool isFixed, Contactful with) {
    BodyTemplate kind;
    kind.name = "body";
    kind.form = form;
    kind.isFixed = isFixed;
    kind.friction = with.friction;
    kind.restitution = with.restitution;
    kind.rollingFrictionMetres = with.rollingFriction;
    return {.model = makeRigidBodyModel(kind, object).value()};
}

inline RigidWorld::Kind ballKind(double radiusMetres, Contactful with = {}) {
    auto object = objectOf(icosphereMesh(radiusMetres, 3), "Steel");
    const double mass = 4.0 / 3 * std::numbers::pi * std::pow(radiusMetres, 3) * 7850;
    const double inertia = 0.4 * mass * radiusMetres * radiusMetres;
    object->mass = {.massKg = mass, .inertiaKgM2 = {inertia, 0, 0, 0, inertia, 0, 0, 0, inertia}};
    return kindOf(object, BodyForm::sphere, false, with);
}

inline RigidWorld::Kind cubeKind(double sideMetres, Contactful with = {}) {
    auto object = objectOf(
        boxMesh(Eigen::Vector3d::Constant(sideMetres), Eigen::Vector3i::Constant(2)), "Steel");
    const double mass = std::pow(sideMetres, 3) * 7850;
    const double inertia = mass * sideMetres * sideMetres / 6;
    object->mass = {.massKg = mass, .inertiaKgM2 = {inertia, 0, 0, 0, inertia, 0, 0, 0, inertia}};
    return kindOf(object, BodyForm::hull, false, with);
}

/// Returns steel ground below z = 0.
inline RigidWorld::Kind groundKind(Contactful with = {}) {
    return kindOf(objectOf(sheetMesh(1, 1, 50), "Steel"), BodyForm::ground, true, with);
}

inline BodyMotion at(const Eigen::Vector3d& place,
                     const Eigen::Vector3d& velocity = Eigen::Vector3d::Zero(),
                     const Eigen::Vector3d& spin = Eigen::Vector3d::Zero()) {
    return {
        .pose = Eigen::Isometry3d(Eigen::Translation3d(place)), .velocity = velocity, .spin = spin};
}

} // namespace idiophone::test
