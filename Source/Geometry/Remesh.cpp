#include "Geometry/Remesh.h"

#include "Geometry/CgalSurface.h"
#include "Geometry/Decimation.h"
#include "Geometry/MeshRepair.h"
#include "Mesh/SurfaceQuery.h"

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

namespace idiophone {
namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using Vertex = Surface::Vertex_index;
using Edge = Surface::Edge_index;
using Face = Surface::Face_index;

void checkCancelled(const WorkControl& control) {
    if (control.isCancelled())
        throw Stopped{std::string(cancelledMessage)};
}

/// Limits how often CGAL may query edges. It counts queries rather than time, so that the same mesh
/// always gives the same result.
class QueryBudget {
public:
    QueryBudget(const WorkControl& control, std::int64_t queries)
        : control_(control), left_(queries) {}

    void spend() {
        if (--left_ < 0)
            throw Stopped{"The mesh cannot be remeshed in reasonable time: its faces are too "
                          "thin."};
        if (left_ % 1024 == 0)
            checkCancelled(control_);
    }

private:
    const WorkControl& control_;
    std::int64_t left_;
};

/// The property map of sharp edges. CGAL's loops can be left only by throwing from its queries.
struct SharpEdges {
    using key_type = Edge;
    using value_type = bool;
    using reference = bool;
    using category = boost::read_write_property_map_tag;

    friend bool get(const SharpEdges& edges, Edge edge) {
        edges.budget->spend();
        return edges.isSharp[edge];
    }
    friend void put(const SharpEdges& edges, Edge edge, bool sharp) {
        edges.budget->spend();
        edges.isSharp[edge] = sharp;
    }

    Surface::Property_map<Edge, bool> isSharp;
    QueryBudget* budget = nullptr;
};

/// The features to preserve: edges, corners, and the patches of faces between those edges.
struct Features {
    Surface::Property_map<Edge, bool> isSharp;
    Surface::Property_map<Vertex, bool> isCorner;
    Surface::Property_map<Face, std::size_t> patchOf;
    std::size_t patchCount = 0;
};

bool turnsSharply(const UnitSurface& unit, Vertex vertex, Vertex a, Vertex b, double cosine) {
    const Eigen::RowVector3d in = unit.unitPoint(vertex) - unit.unitPoint(a);
    const Eigen::RowVector3d out = unit.unitPoint(b) - unit.unitPoint(vertex);
    return in.dot(out) < cosine * in.norm() * out.norm();
}

/// Returns true if sharp edges or boundaries end, meet or turn sharply at the vertex.
bool isCorner(const UnitSurface& unit, const Features& features, Vertex vertex, double cosine) {
    std::vector<Vertex> ends;
    for (const auto h : unit.surface.halfedges_around_target(unit.surface.halfedge(vertex))) {
        const auto edge = unit.surface.edge(h);
        if (features.isSharp[edge] || unit.surface.is_border(edge))
            ends.push_back(unit.surface.source(h));
    }
    return !ends.empty() &&
           (ends.size() != 2 || turnsSharply(unit, vertex, ends[0], ends[1], cosine));
}

Features findFeatures(UnitSurface& unit) {
    constexpr double sharpAngleDegrees = 40;
    Features features{
        .isSharp = unit.surface.add_property_map<Edge, bool>("e:sharp", false).first,
        .isCorner = unit.surface.add_property_map<Vertex, bool>("v:corner", false).first,
        .patchOf = unit.surface.add_property_map<Face, std::size_t>("f:patch", 0).first};
    pmp::detect_sharp_edges(unit.surface, sharpAngleDegrees, features.isSharp);
    const double cosine = std::cos(sharpAngleDegrees * std::numbers::pi / 180);
    for (const auto vertex : unit.surface.vertices())
        features.isCorner[vertex] = isCorner(unit, features, vertex, cosine);
    features.patchCount =
        pmp::connected_components(unit.surface, features.patchOf,
                                  CGAL::parameters::edge_is_constrained_map(features.isSharp));
    return features;
}

/// Returns the original faces of each patch, for nearest-point queries.
std::vector<SurfaceQuery> patchesOf(const UnitSurface& unit, const Features& features) {
    std::vector<std::vector<Face>> facesOf(features.patchCount);
    for (const auto face : unit.surface.faces())
        facesOf[features.patchOf[face]].push_back(face);
    std::vector<SurfaceQuery> result;
    result.reserve(facesOf.size());
    for (const auto& faces : facesOf) {
        Mesh patch{Eigen::MatrixXd(3 * faces.size(), 3), Eigen::MatrixXi(faces.size(), 3)};
        int row = 0;
        for (const auto face : faces)
            for (const auto vertex :
                 unit.surface.vertices_around_face(unit.surface.halfedge(face))) {
                patch.vertices.row(row) = unit.unitPoint(vertex);
                patch.faces(row / 3, row % 3) = row;
                ++row;
            }
        result.emplace_back(std::move(patch));
    }
    return result;
}

/// Projects a smoothed vertex back onto the original surface.
class Projection {
public:
    Projection(const UnitSurface& unit,
               const Features& features,
               const std::vector<SurfaceQuery>& patches,
               const WorkControl& control)
        : unit_(unit), features_(features), patches_(patches), control_(control) {}

    Surface::Point operator()(Vertex vertex) const {
        checkCancelled(control_);
        const Eigen::Vector3d point = unit_.unitPoint(vertex).transpose();
        if (!point.allFinite())
            throw Stopped{"The mesh cannot be remeshed: its faces are too thin for arithmetic."};
        const auto face = unit_.surface.face(unit_.surface.halfedge(vertex));
        const auto nearest = patches_[features_.patchOf[face]].nearestPoint(point).pointMetres;
        return {nearest.x(), nearest.y(), nearest.z()};
    }

private:
    const UnitSurface& unit_;
    const Features& features_;
    const std::vector<SurfaceQuery>& patches_;
    const WorkControl& control_;
};

/// A scan of 500,000 triangles takes 1.6 million queries. A tube whose triangles are as long as the
/// tube takes 3 million. Both take ten seconds; needles would take hours.
std::int64_t queriesAllowed(const UnitSurface& unit) {
    return 4'000'000 + 20 * static_cast<std::int64_t>(unit.surface.number_of_faces());
}

/// Returns true if too many faces meet in single vertices. Some of CGAL's steps take quadratic time
/// there, without any query that could stop them.
bool isCrowded(const Mesh& mesh) {
    Eigen::VectorXd degrees = Eigen::VectorXd::Zero(mesh.vertexCount());
    for (const int vertex : mesh.faces.reshaped())
        ++degrees(vertex);
    return degrees.squaredNorm() > 4e8 + 100 * static_cast<double>(mesh.faceCount());
}

void remeshUnit(UnitSurface& unit, double edgeLength, const WorkControl& control) {
    constexpr int passes = 5; // each splits, collapses, flips and smooths
    const auto features = findFeatures(unit);
    const auto patches = patchesOf(unit, features);
    QueryBudget budget(control, queriesAllowed(unit));
    for (int pass = 0; pass < passes; ++pass) {
        control.report(static_cast<double>(pass) / passes, "Remeshing");
        checkCancelled(control);
        pmp::isotropic_remeshing(
            unit.surface.faces(), edgeLength, unit.surface,
            CGAL::parameters::number_of_iterations(1)
                .edge_is_constrained_map(SharpEdges{features.isSharp, &budget})
                .vertex_is_constrained_map(features.isCorner)
                .face_patch_map(features.patchOf)
                .projection_functor(Projection(unit, features, patches, control)));
    }
    control.report(1, "Remeshing");
}

/// Decimation keeps this many vertices per remeshed vertex, so that it moves the surface far less
/// than remeshing does.
constexpr double verticesKept = 8;

/// Returns nothing if the mesh is not dense enough to benefit, or if decimation fails.
std::optional<Mesh>
decimatedFor(double edgeLengthMetres, const Mesh& mesh, const WorkControl& control) {
    const double areaPerVertexM2 = std::sqrt(3.0) / 2 * edgeLengthMetres * edgeLengthMetres;
    const double wanted = verticesKept * faceAreas(mesh).sum() / areaPerVertexM2;
    if (!(2 * wanted < static_cast<double>(mesh.vertexCount())))
        return {};
    const auto decimated =
        decimate(mesh, std::max(1000, static_cast<int>(wanted)), control.quiet());
    if (!decimated)
        return {};
    // Collapses may bring vertices together.
    auto repaired =
        repairMesh(*decimated, {.cutIntoManifold = true, .cancelled = control.cancelled});
    if (!repaired)
        return {};
    return std::move(repaired->mesh);
}

} // namespace

double remeshedTriangles(const Mesh& mesh, double edgeLengthMetres) {
    double triangles = 0;
    for (Eigen::Index face = 0; face < mesh.faceCount(); ++face) {
        const Eigen::RowVector3d a = mesh.vertices.row(mesh.faces(face, 0));
        const Eigen::RowVector3d u =
            (mesh.vertices.row(mesh.faces(face, 1)) - a) / edgeLengthMetres;
        const Eigen::RowVector3d v =
            (mesh.vertices.row(mesh.faces(face, 2)) - a) / edgeLengthMetres;
        triangles +=
            u.cross(v).norm() / 2 * 4 / std::sqrt(3.0) + (u.norm() + v.norm() + (u - v).norm()) / 2;
    }
    return triangles;
}

Result<Mesh> remesh(const Mesh& mesh, double edgeLengthMetres, const WorkControl& control) {
    constexpr int maximumTriangles = 4'000'000; // a million take about 1 GB and half a minute
    return withoutExceptions("remeshed", [&]() -> Result<Mesh> {
        const auto repaired =
            repairMesh(mesh, {.cutIntoManifold = true, .cancelled = control.cancelled});
        if (!repaired)
            return tl::unexpected(repaired.error());
        const Mesh& sound = repaired->mesh;
        if (!(edgeLengthMetres > 0 && edgeLengthMetres <= boundingDiagonalMetres(sound) / 2))
            return failure("The edge length of a remeshing must be above 0 and at most half of the "
                           "mesh's bounding diagonal.");
        if (!(remeshedTriangles(sound, edgeLengthMetres) <= maximumTriangles))
            return failure("The mesh would need more than " + std::to_string(maximumTriangles) +
                           " triangles at this edge length; choose a longer one.");
        if (isCrowded(sound))
            return failure("The mesh cannot be remeshed in reasonable time: too many of its faces "
                           "meet in one vertex.");
        const auto lighter = decimatedFor(edgeLengthMetres, sound, control);
        checkCancelled(control);
        auto unit = unitSurfaceOf(lighter ? *lighter : sound);
        remeshUnit(unit, edgeLengthMetres / unit.diagonalMetres, control);
        return meshOf(unit);
    });
}

} // namespace idiophone
