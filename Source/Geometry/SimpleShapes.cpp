#include "Geometry/SimpleShapes.h"

#include "Geometry/ParametricMesh.h"
#include "Geometry/TurnedSections.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <ranges>
#include <string>
#include <vector>

namespace idiophone {
namespace {

constexpr double pi = std::numbers::pi;

/// Returns the edge of near-equilateral triangles if `vertexCount` vertices cover an area.
double edgeFor(double areaM2, int vertexCount) {
    return std::sqrt(areaM2 / vertexCount * 2 / std::sqrt(3.0));
}

int divisions(double lengthMetres, double edgeMetres, int least) {
    return std::max(least, static_cast<int>(std::lround(lengthMetres / edgeMetres)));
}

int evenDivisions(double lengthMetres, double edgeMetres) {
    return 2 * divisions(lengthMetres / 2, edgeMetres, 3);
}

Mesh sheet(const ShapeSizes& s) {
    return sheetMesh(s.lengthMetres, s.widthMetres, s.vertexCount);
}

Mesh box(const ShapeSizes& s) {
    const Eigen::Vector3d size(s.lengthMetres, s.widthMetres, s.heightMetres);
    const double area = 2 * (size.x() * size.y() + size.y() * size.z() + size.z() * size.x());
    const double edge = std::sqrt(area / s.vertexCount);
    return boxMesh(size, {divisions(size.x(), edge, 1), divisions(size.y(), edge, 1),
                          divisions(size.z(), edge, 1)});
}

Mesh disc(const ShapeSizes& s) {
    return discMesh(s.radiusMetres,
                    std::max(1, static_cast<int>(std::lround(std::sqrt(s.vertexCount / 3.0)))));
}

Mesh icosphere(const ShapeSizes& s) {
    const double level = std::log2(std::max(1.0, (s.vertexCount - 2) / 10.0)) / 2;
    return icosphereMesh(s.radiusMetres, static_cast<int>(std::lround(level)));
}

Mesh ring(const ShapeSizes& s) {
    const double around = 2 * pi * s.radiusMetres, section = 2 * pi * s.sectionRadiusMetres;
    const double edge = edgeFor(around * section, s.vertexCount);
    return torusMesh(s.radiusMetres, s.sectionRadiusMetres, evenDivisions(around, edge),
                     divisions(section, edge, 3));
}

Mesh hoop(const ShapeSizes& s) {
    const double around = 2 * pi * s.radiusMetres;
    const double edge = edgeFor(around * s.heightMetres, s.vertexCount);
    return hoopMesh(s.radiusMetres, s.heightMetres, evenDivisions(around, edge),
                    divisions(s.heightMetres, edge * std::sqrt(3.0) / 2, 1));
}

double footRadiusOf(const ShapeSizes& s) {
    return s.footRadiusMetres > 0 ? s.footRadiusMetres : 0.4 * s.radiusMetres;
}

double turnedAreaM2(const std::vector<LathePoint>& section) {
    double area = 0;
    for (std::size_t i = 1; i < section.size(); ++i)
        area += pi * (section[i].radiusMetres + section[i - 1].radiusMetres) *
                std::hypot(section[i].radiusMetres - section[i - 1].radiusMetres,
                           section[i].heightMetres - section[i - 1].heightMetres);
    return area;
}

Mesh bowl(const ShapeSizes& s) {
    const double foot = footRadiusOf(s), wall = s.thicknessMetres;
    const auto sectionOf = [](double rim, double height, double ofFoot) {
        return bowlSection({.rimRadiusMetres = rim,
                            .heightMetres = height,
                            .footRadiusMetres = ofFoot,
                            .footThicknessMetres = 0,
                            .rimThicknessMetres = 0});
    };
    auto section = sectionOf(s.radiusMetres, s.heightMetres, foot);
    if (wall > 0) { // a smaller bowl of the same kind, inside
        const double rim = s.radiusMetres - wall;
        const auto inside = sectionOf(rim, s.heightMetres - wall, foot * rim / s.radiusMetres);
        for (auto point : std::views::reverse(inside)) {
            point.heightMetres += wall;
            section.push_back(point);
        }
    }
    return latheMesh(section, edgeFor(turnedAreaM2(section), s.vertexCount)).mesh;
}

struct Shape {
    std::string_view name;
    Mesh (*make)(const ShapeSizes&);
};

constexpr std::array shapes{
    Shape{"bar", sheet}, Shape{"plate", sheet},         Shape{"box", box},   Shape{"disc", disc},
    Shape{"ring", ring}, Shape{"icosphere", icosphere}, Shape{"hoop", hoop}, Shape{"bowl", bowl}};

constexpr auto names = [] {
    std::array<std::string_view, shapes.size()> result;
    std::ranges::transform(shapes, result.begin(), &Shape::name);
    return result;
}();

/// Returns why sizes contradict each other, or nothing.
std::string_view contradiction(std::string_view name, const ShapeSizes& s) {
    if (name == "ring" && s.sectionRadiusMetres >= s.radiusMetres)
        return "the radius of its cross-section must be smaller than its own";
    if (name == "bowl" && footRadiusOf(s) >= s.radiusMetres)
        return "its foot must be narrower than its rim";
    if (name == "bowl" && s.thicknessMetres >= std::min(s.radiusMetres, s.heightMetres) / 2)
        return "its wall must be thinner than half its radius and half its height";
    return {};
}

} // namespace

std::span<const std::string_view> simpleShapeNames() {
    return names;
}

Result<Mesh> simpleShape(std::string_view name, const ShapeSizes& sizes) {
    const auto* shape = std::ranges::find(shapes, name, &Shape::name);
    const auto refuse = [&](std::string_view why) {
        return failure("The " + std::string(name) + " cannot be made: " + std::string(why) + ".");
    };
    if (shape == shapes.end())
        return refuse("there is no such shape");
    if (const auto why = contradiction(name, sizes); !why.empty())
        return refuse(why);
    auto mesh = shape->make(sizes);
    if (mesh.vertexCount() > 2 * maximumShapeVertices)
        return refuse("with these proportions it would have " + std::to_string(mesh.vertexCount()) +
                      " vertices");
    return mesh;
}

} // namespace idiophone
