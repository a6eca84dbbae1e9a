#include "Scene/RigidBodyModel.h"

#include "Geometry/MeshCleaning.h"
#include "Geometry/Subdivision.h"
#include "Instrument/ContactLaw.h"
#include "Mesh/ObjectMesh.h"
#include "Object/OneLine.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace idiophone {
namespace {

// With smaller bodies, the solver would divide by numbers that are too small.
constexpr double minimumMetres = 1e-9, minimumMassKg = 1e-24;

/// Returns right-handed axes in columns, in ascending order of inertia.
Eigen::Matrix3d principalAxes(const Eigen::Matrix3d& inertia, Eigen::Vector3d& moments) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(inertia);
    moments = solver.eigenvalues();
    Eigen::Matrix3d axes = solver.eigenvectors();
    if (axes.determinant() < 0)
        axes.col(2) = -axes.col(2);
    return axes;
}

/// The radius of flat bodies, larger than that of any body that falls on them.
constexpr double flatRadiusMetres = 1000;

/// Returns the radius where a body is most likely to be touched. Fixed bodies are flat. Edges and
/// corners of moving ones are rounded by a tenth of their smallest size.
double ownContactRadius(const RigidBodyModel& model, const Eigen::Vector3d& sizes) {
    if (model.form == BodyForm::sphere)
        return sizes.mean() / 2;
    if (model.form == BodyForm::cylinder)
        return sizes.head<2>().maxCoeff() / 2;
    return model.isFixed ? flatRadiusMetres : sizes.minCoeff() / 10;
}

/// Counts the touching faces of a surface by their boxes. Bullet looks for the neighbours of each
/// face in this tree (SurfaceShape), and for the common edge of each pair.
Result<BoxSearch> touchingFaces(const BodyTemplate& kind, const ModalObject& object) {
    const auto fault = [&](const std::string& why) {
        return failure(inQuotes(kind.name) + " is no surface: its object " + inQuotes(object.name) +
                       " has " + why);
    };
    if (object.faceCount() == 0)
        return fault("no faces");
    // Bullet numbers faces with 21 bits and does not check.
    if (object.faceCount() > maximumSurfaceFaces)
        return fault("more than " + std::to_string(maximumSurfaceFaces) + " faces");
    const auto mesh = collisionSurface(object, kind.form);
    if (mesh.faceCount() == 0)
        return fault("no face with an area");
    if (const auto touching = BoxTree(mesh).touchingFaces(maximumTouchingFaces))
        return *touching;
    return fault("too many faces that lie on or across each other");
}

} // namespace

Result<std::shared_ptr<const RigidBodyModel>>
makeRigidBodyModel(const BodyTemplate& kind, std::shared_ptr<const ModalObject> object) {
    const auto& own = *object;
    const double s = kind.sizeRatio;
    const auto& material = own.material;
    RigidBodyModel model{
        .object = object,
        .form = kind.form,
        .isFixed = kind.isFixed,
        .sizeRatio = s,
        .massKg = own.mass.massKg * s * s * s,
        .inertiaKgM2 = Eigen::Vector3d::Zero(),
        .meshFromBody = Eigen::Isometry3d::Identity(),
        .friction = kind.friction.value_or(material.friction),
        .restitution = kind.restitution.value_or(material.restitution),
        .rollingFrictionMetres = kind.rollingFrictionMetres,
        .compliancePerPa = elasticCompliancePerPa(material.youngsModulusPa, material.poissonRatio)};
    if (!kind.isFixed) {
        const Eigen::Matrix3d inertia =
            Eigen::Map<const Eigen::Matrix3d>(own.mass.inertiaKgM2.data()) * std::pow(s, 5);
        model.meshFromBody.linear() = principalAxes(inertia, model.inertiaKgM2);
        model.meshFromBody.translation() =
            s * Eigen::Map<const Eigen::Vector3d>(own.mass.centreMetres.data());
        if (!(model.massKg > minimumMassKg) ||
            !(model.inertiaKgM2.minCoeff() > minimumMetres * minimumMetres * model.massKg))
            return failure(inQuotes(kind.name) + " cannot move: its object " + inQuotes(own.name) +
                           " has no mass");
    }
    if (hasFaces(kind.form)) {
        const auto touching = touchingFaces(kind, own);
        if (!touching)
            return tl::unexpected(touching.error());
        model.touchingFaces = *touching;
    }
    const Eigen::Vector3d sizes = boundingBox(outerVertices(model)).sizes();
    if (!(sizes.minCoeff() > minimumMetres) && !hasFaces(kind.form) &&
        kind.form != BodyForm::ground)
        return failure(inQuotes(kind.name) + " is as flat as a sheet: its object " +
                       inQuotes(own.name) + " has no thickness");
    model.contactRadiusMetres =
        kind.contactRadiusMetres > 0 ? kind.contactRadiusMetres : ownContactRadius(model, sizes);
    return std::make_shared<const RigidBodyModel>(std::move(model));
}

Mesh collisionSurface(const ModalObject& object, BodyForm form) {
    constexpr Eigen::Index maximumSmoothFaces = 24000; // each subdivision turns one face into four
    Mesh mesh = objectMesh(object);
    dropDegenerateFaces(mesh);
    dropDuplicateFaces(mesh);
    if (form == BodyForm::mesh)
        return mesh;
    for (auto faces = 4 * mesh.faceCount(); faces > 0 && faces <= maximumSmoothFaces; faces *= 4)
        mesh = subdivided(mesh, 1);
    return mesh;
}

std::vector<Eigen::Vector3d> outerVertices(const RigidBodyModel& model) {
    const auto& object = *model.object;
    const double half = object.body == BodyKind::shell ? object.thicknessMetres / 2 : 0;
    const auto normals = vertexNormals(object);
    std::vector<Eigen::Vector3d> points;
    for (std::size_t k = 0; k < object.vertices.size(); k += 3) {
        const Eigen::Vector3d vertex =
            Eigen::Map<const Eigen::Vector3f>(&object.vertices[k]).cast<double>();
        const Eigen::Vector3d out =
            half * Eigen::Map<const Eigen::Vector3f>(&normals[k]).cast<double>();
        points.emplace_back(model.sizeRatio * (vertex + out));
        if (half > 0)
            points.emplace_back(model.sizeRatio * (vertex - out));
    }
    return points;
}

double relativeRadiusMetres(const RigidBodyModel& first, const RigidBodyModel& second) {
    return 1 / (1 / first.contactRadiusMetres + 1 / second.contactRadiusMetres);
}

double contactSeconds(const RigidBodyModel& first,
                      const RigidBodyModel& second,
                      double effectiveMassKg,
                      double metresPerSecond) {
    const double modulusPa = 1 / (first.compliancePerPa + second.compliancePerPa);
    const auto law = contactLaw(relativeRadiusMetres(first, second), modulusPa);
    return contactSeconds(law, effectiveMassKg, metresPerSecond);
}

Eigen::AlignedBox3d boundingBox(const std::vector<Eigen::Vector3d>& points) {
    Eigen::AlignedBox3d box;
    for (const auto& point : points)
        box.extend(point);
    return box;
}

} // namespace idiophone
