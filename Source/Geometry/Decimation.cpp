#include "Geometry/Decimation.h"

#include "Geometry/CgalSurface.h"
#include "Geometry/MeshRepair.h"

#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Bounded_normal_change_filter.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/GarlandHeckbert_probabilistic_plane_policies.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>

namespace idiophone {
namespace {

constexpr std::string_view decimating = "Simplifying the mesh";

namespace sms = CGAL::Surface_mesh_simplification;

/// Stops at the budget or on cancellation.
class BudgetReached {
public:
    BudgetReached(std::size_t initialVertices, std::size_t budget, const WorkControl& control)
        : initial_(initialVertices), budget_(budget), control_(control) {}

    template <class Cost, class Profile>
    bool operator()(const Cost&, const Profile& profile, std::size_t, std::size_t edges) const {
        const std::size_t vertices = profile.surface_mesh().number_of_vertices();
        if (edges % 1024 == 0 && initial_ > budget_)
            control_.report(static_cast<double>(initial_ - std::max(vertices, budget_)) /
                                static_cast<double>(initial_ - budget_),
                            decimating);
        return vertices <= budget_ || control_.isCancelled();
    }

private:
    std::size_t initial_, budget_;
    const WorkControl& control_;
};

/// Limits CGAL's work. After a collapse, CGAL visits all edges around both ends of each moved edge.
/// If n faces meet in one vertex, this takes O(n³). Throws Stopped if there are too many visits or
/// on cancellation.
template <class Placement>
class LimitedPlacement {
public:
    LimitedPlacement(const Placement& placement,
                     std::int64_t& neighboursLeft,
                     const WorkControl& control)
        : placement_(placement), neighboursLeft_(neighboursLeft), control_(control) {}

    template <class Profile>
    auto operator()(const Profile& profile) const {
        neighboursLeft_ -= static_cast<std::int64_t>(profile.link().size());
        if (control_.isCancelled())
            throw Stopped{std::string(cancelledMessage)};
        if (neighboursLeft_ < 0)
            throw Stopped{"The mesh cannot be decimated: too many of its faces meet in one "
                          "vertex."};
        return placement_(profile);
    }

private:
    const Placement& placement_;
    std::int64_t& neighboursLeft_;
    const WorkControl& control_;
};

/// A scan needs about 160 visits per face, of about 10 ns each.
std::int64_t neighboursAllowed(const UnitSurface& unit) {
    return 300'000'000 + 1000 * static_cast<std::int64_t>(unit.surface.number_of_faces());
}

using Policies = sms::GarlandHeckbert_probabilistic_plane_policies<Surface, SurfaceKernel>;

/// Probabilistic quadrics (Trettner & Kobbelt 2020). With plain quadrics, every collapse on a flat
/// surface costs nothing and produces needles. Remeshing needles takes a hundred times as long. The
/// variance moves edges and corners by far less than 1e-6 of the mesh's size.
Policies policiesFor(Surface& surface) {
    constexpr double variance = 1e-10; // of normals and of positions (bounding diagonal 1)
    constexpr double border = 100;     // CGAL's default weight of the boundary
    return {surface, border,
            CGAL::Constant_property_map<Surface::Face_index, std::pair<double, double>>(
                {variance, variance})};
}

void collapseEdges(UnitSurface& unit, std::size_t budget, const WorkControl& control) {
    const BudgetReached stop(unit.surface.number_of_vertices(), budget, control);
    auto neighboursLeft = neighboursAllowed(unit);
    const auto placement = [&](const Policies& policies) {
        return LimitedPlacement(policies.get_placement(), neighboursLeft, control);
    };
    {
        const auto policies = policiesFor(unit.surface);
        sms::edge_collapse(unit.surface, stop,
                           CGAL::parameters::get_cost(policies.get_cost())
                               .get_placement(placement(policies))
                               .filter(sms::Bounded_normal_change_filter<>()));
    }
    if (unit.surface.number_of_vertices() <= budget || control.isCancelled())
        return;
    // On crumpled scans, the normal filter blocks all collapses before the budget is reached. Retry
    // without it.
    unit.surface.collect_garbage();
    const auto policies = policiesFor(unit.surface);
    sms::edge_collapse(
        unit.surface, stop,
        CGAL::parameters::get_cost(policies.get_cost()).get_placement(placement(policies)));
}

} // namespace

Result<Mesh> decimate(const Mesh& mesh, int vertexBudget, const WorkControl& control) {
    if (vertexBudget < 4)
        return failure("A mesh cannot be decimated to fewer than 4 vertices.");
    return withoutExceptions("decimated", [&]() -> Result<Mesh> {
        const auto repaired =
            repairMesh(mesh, {.cutIntoManifold = true, .cancelled = control.cancelled});
        if (!repaired)
            return tl::unexpected(repaired.error());
        auto unit = unitSurfaceOf(repaired->mesh);
        const auto budget = static_cast<std::size_t>(vertexBudget);
        if (unit.surface.number_of_vertices() > budget)
            collapseEdges(unit, budget, control);
        if (control.isCancelled())
            return cancellation();
        control.report(1, decimating);
        auto result = meshOf(unit);
        if (result && result->vertexCount() > vertexBudget)
            return failure("The mesh cannot be decimated to " + std::to_string(vertexBudget) +
                           " vertices: its holes and components need " +
                           std::to_string(result->vertexCount()) + ".");
        return result;
    });
}

} // namespace idiophone
