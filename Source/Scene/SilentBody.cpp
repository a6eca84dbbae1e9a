#include "Scene/SilentBody.h"

#include "Geometry/ParametricMesh.h"
#include "Mesh/ObjectMesh.h"

#include <algorithm>
#include <numbers>

namespace idiophone {

std::shared_ptr<const ModalObject> silentBall(double radiusMetres, const Material& material) {
    auto object = std::make_shared<ModalObject>();
    object->name = "ball";
    object->material = material;
    const double r = radiusMetres;
    const double mass = 4.0 / 3 * std::numbers::pi * r * r * r * object->material.densityKgPerM3;
    const double inertia = 0.4 * mass * r * r;
    object->mass = {.massKg = mass, .inertiaKgM2 = {inertia, 0, 0, 0, inertia, 0, 0, 0, inertia}};
    setMesh(*object, icosphereMesh(r, 2));
    return object;
}

MassProperties withInertia(MassProperties mass, const Eigen::AlignedBox3d& box) {
    if (std::ranges::any_of(mass.inertiaKgM2, [](double moment) { return moment != 0; }))
        return mass;
    const Eigen::Vector3d squares = box.sizes().cwiseAbs2();
    for (std::size_t axis = 0; axis < 3; ++axis)
        mass.inertiaKgM2[4 * axis] =
            mass.massKg / 12 * (squares.sum() - squares(static_cast<Eigen::Index>(axis)));
    return mass;
}

std::shared_ptr<const ModalObject> silentBody(const std::vector<Eigen::Vector3d>& pointsMetres,
                                              const std::vector<std::array<int, 3>>& faces,
                                              const Material& material,
                                              const MassProperties& mass) {
    auto object = std::make_shared<ModalObject>();
    object->name = material.name;
    object->material = material;
    Eigen::AlignedBox3d box;
    for (const auto& point : pointsMetres) {
        box.extend(point);
        for (const double metres : point)
            object->vertices.push_back(static_cast<float>(metres));
    }
    for (const auto& corners : faces)
        object->faces.insert(object->faces.end(), corners.begin(), corners.end());
    object->mass = mass;
    if (!(mass.massKg > 0)) {
        object->mass.massKg = box.volume() * material.densityKgPerM3;
        Eigen::Map<Eigen::Vector3d>(object->mass.centreMetres.data()) = box.center();
    }
    object->mass = withInertia(object->mass, box);
    return object;
}

} // namespace idiophone
