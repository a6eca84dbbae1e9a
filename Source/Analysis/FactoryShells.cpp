#include "Analysis/FactoryShells.h"

#include "Geometry/ParametricMesh.h"
#include "Geometry/TurnedSections.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace idiophone {
namespace {

std::vector<LathePoint> singingBowlSection() {
    constexpr LathePoint points[] = {
        {0, 0, 0.003},         {0.04, 0, 0.003},     {0.062, 0.008, 0.003}, {0.08, 0.032, 0.0028},
        {0.088, 0.062, 0.003}, {0.09, 0.08, 0.0055}, {0.0905, 0.088, 0.006}};
    return smoothSection(points);
}

/// The bowl of the glass; its stem hardly moves.
std::vector<LathePoint> wineGlassSection() {
    constexpr LathePoint points[] = {{0, 0, 0.005},           {0.008, 0.0005, 0.0045},
                                     {0.024, 0.008, 0.0035},  {0.036, 0.024, 0.0024},
                                     {0.041, 0.044, 0.00155}, {0.0405, 0.059, 0.0012},
                                     {0.038, 0.072, 0.0011}};
    return smoothSection(points);
}

std::vector<LathePoint> crotaleSection() {
    constexpr LathePoint points[] = {{0.05, 0, 0.005},  {0.011, 0, 0.005}, {0.011, 0, 0.005},
                                     {0.009, 0, 0.016}, {0.009, 0, 0.016}, {0, 0, 0.016}};
    return smoothSection(points);
}

std::vector<LathePoint> fingerCymbalSection() {
    constexpr LathePoint points[] = {{0.03, 0, 0.0014},
                                     {0.016, 0.001, 0.0016},
                                     {0.012, 0.0025, 0.0016},
                                     {0.008, 0.007, 0.0016},
                                     {0, 0.009, 0.0016}};
    return smoothSection(points);
}

std::vector<LathePoint> agogoSection() {
    constexpr LathePoint points[] = {{0.037, 0, 0.0012},
                                     {0.013, 0.125, 0.0012},
                                     {0.013, 0.125, 0.0012},
                                     {0.007, 0.132, 0.0012},
                                     {0, 0.133, 0.0012}};
    return smoothSection(points);
}

std::vector<LathePoint> brakeDrumSection() {
    constexpr LathePoint points[] = {
        {0.035, 0, 0.009},     {0.115, 0, 0.009},     {0.135, 0.012, 0.009}, {0.137, 0.03, 0.009},
        {0.138, 0.075, 0.009}, {0.139, 0.082, 0.014}, {0.139, 0.095, 0.014}};
    return smoothSection(points);
}

std::vector<LathePoint> bottleSection() {
    constexpr LathePoint points[] = {
        {0, 0.004, 0.005},      {0.03, 0.001, 0.004},    {0.036, 0.008, 0.0032},
        {0.037, 0.02, 0.0028},  {0.037, 0.18, 0.0028},   {0.033, 0.205, 0.003},
        {0.018, 0.235, 0.0032}, {0.0135, 0.255, 0.0034}, {0.013, 0.29, 0.0042}};
    return smoothSection(points);
}

std::vector<LathePoint> gongSection() {
    constexpr LathePoint points[] = {
        {0.15, -0.04, 0.0028}, {0.145, -0.01, 0.0024}, {0.12, -0.004, 0.0022}, {0.03, 0, 0.0026},
        {0.026, 0.002, 0.003}, {0.018, 0.011, 0.0035}, {0, 0.014, 0.0035}};
    return smoothSection(points);
}

/// Measures found by a search for the partials 1 : 2 : 2.4 : 3 : 4 of a bell with a minor third.
std::vector<LathePoint> churchBellSection() {
    constexpr LathePoint points[] = {{0.475, 0, 0.0462},     {0.445, 0.07, 0.0833},
                                     {0.3559, 0.16, 0.0532}, {0.3195, 0.28, 0.0351},
                                     {0.2951, 0.42, 0.0307}, {0.2871, 0.56, 0.0314},
                                     {0.2748, 0.66, 0.0366}, {0.2409, 0.722, 0.036},
                                     {0.15, 0.752, 0.038},   {0, 0.757, 0.04}};
    return smoothSection(points);
}

std::vector<LathePoint> templeBlockSection() {
    constexpr LathePoint points[] = {{0, -0.038, 0.0162},     {0.02, -0.037, 0.0162},
                                     {0.044, -0.026, 0.0148}, {0.056, -0.002, 0.0135},
                                     {0.044, 0.024, 0.0051},  {0.02, 0.036, 0.0051},
                                     {0, 0.038, 0.0051}};
    return smoothSection(points);
}

/// A folded sheet: a turned cup whose circles become rounded rectangles, wide at the mouth.
LatheMesh cowbellWall() {
    constexpr double radius = 0.045, height = 0.14, wall = 0.0015, squareness = 4;
    constexpr LathePoint points[] = {{radius, 0, wall},
                                     {radius, height - 0.016, wall},
                                     {radius - 0.002, height - 0.006, wall},
                                     {radius - 0.01, height, wall},
                                     {0, height, wall}};
    LatheMesh cup = latheMesh(smoothSection(points), 0.0095);
    for (auto vertex : cup.mesh.vertices.rowwise()) {
        const double away = vertex.head<2>().norm(), share = vertex.z() / height;
        if (away == 0)
            continue;
        const double c = std::abs(vertex.x()) / away, s = std::abs(vertex.y()) / away;
        const double corner =
            std::pow(std::pow(c, squareness) + std::pow(s, squareness), -1 / squareness);
        vertex.x() *= corner * std::lerp(0.052, 0.037, share) / radius;
        vertex.y() *= corner * std::lerp(0.034, 0.017, share) / radius;
    }
    return cup;
}

/// The top is thin and moves; the bottom is thick.
LatheMesh woodBlockWall() {
    LatheMesh box{boxMesh({0.17, 0.09, 0.02}, {18, 9, 2}), {}};
    box.thicknessMetres.resize(box.mesh.vertexCount());
    for (Eigen::Index v = 0; v < box.mesh.vertexCount(); ++v)
        box.thicknessMetres(v) = std::lerp(0.0195, 0.005, box.mesh.vertices(v, 2) / 0.02 + 0.5);
    return box;
}

bool isWoodBlockSlit(const Eigen::RowVector3d& middle) {
    return middle.y() < -0.0449 && middle.z() > 0 && std::abs(middle.x()) < 0.075;
}

LatheMesh templeBlockWall() {
    return latheMesh(templeBlockSection(), 0.0105);
}

bool isTempleBlockSlit(const Eigen::RowVector3d& middle) {
    return middle.y() < 0.9 * std::abs(middle.x()) && middle.z() > -0.004 && middle.z() < 0.003;
}

constexpr double sleighBellCosine = 0.94, sleighBellSine = 0.3412; // 20°

/// A sphere whose slit, along a row of faces, looks to the front and 20° down.
LatheMesh sleighBellWall() {
    constexpr double radius = 0.014, wall = 0.0011;
    constexpr int steps = 40;
    std::vector<LathePoint> section{{0, -radius, wall}};
    for (int k = 1; k < steps; ++k) {
        const double angle = std::numbers::pi * k / steps;
        section.push_back({radius * std::sin(angle), -radius * std::cos(angle), wall});
    }
    section.push_back({0, radius, wall});
    LatheMesh sphere = latheMesh(section, 0.0038);
    for (auto vertex : sphere.mesh.vertices.rowwise()) {
        const double along = vertex.x(), across = vertex.z();
        vertex.x() = vertex.y();
        vertex.y() = sleighBellCosine * along + sleighBellSine * across;
        vertex.z() = sleighBellSine * along - sleighBellCosine * across;
    }
    return sphere;
}

bool isSleighBellSlit(const Eigen::RowVector3d& middle) {
    const double along = sleighBellCosine * middle.y() + sleighBellSine * middle.z();
    const double across = sleighBellSine * middle.y() - sleighBellCosine * middle.z();
    return along < -0.2 * std::abs(middle.x()) && std::abs(across) < 0.0012;
}

constexpr FactoryShape shells[] = {
    {.name = "singing-bowl",
     .source = "generated Himalayan bowl, 181 mm wide, wall 2.8 to 6 mm; partials of a measured "
               "bowl of 180 mm (Inacio et al. 2006)",
     .material = "Bell bronze",
     .section = singingBowlSection,
     .edgeMetres = 0.011,
     .maxFrequencyHz = 9000,
     .shapeVertexCount = 100,
     .listeners = Listeners::beside},
    {.name = "wine-glass",
     .source = "generated bowl of a wine glass, 80 mm wide, wall 1.1 to 5 mm; partials of a "
               "measured glass",
     .material = "Glass",
     .section = wineGlassSection,
     .edgeMetres = 0.0075,
     .maxFrequencyHz = 16000,
     .shapeVertexCount = 100,
     .listeners = Listeners::beside},
    {.name = "crotale",
     .source = "generated crotale, 100 x 5 mm with a hub of 18 mm (Deutsch et al. 2004)",
     .material = "Bell bronze",
     .section = crotaleSection,
     .edgeMetres = 0.007,
     .maxFrequencyHz = 20000,
     .shapeVertexCount = 90,
     .listeners = Listeners::beside,
     .heldAtMetres = {0, 0, 0.008},
     .heldResistanceNsPerM = 8},
    {.name = "finger-cymbal",
     .source = "generated finger cymbal, 60 mm wide, 1.5 mm, with a boss",
     .material = "Bell bronze",
     .section = fingerCymbalSection,
     .edgeMetres = 0.005,
     .maxFrequencyHz = 22000,
     .shapeVertexCount = 80,
     .listeners = Listeners::beside,
     .heldAtMetres = {0, 0, 0.01},
     .heldResistanceNsPerM = 1},
    {.name = "agogo",
     .source = "generated cone of an agogo, mouth 75 mm, 133 mm long, 1.2 mm",
     .material = "Steel",
     .section = agogoSection,
     .edgeMetres = 0.011,
     .maxFrequencyHz = 12000,
     .shapeVertexCount = 90,
     .listeners = Listeners::beside,
     .heldAtMetres = {0, 0, 0.133},
     .heldResistanceNsPerM = 20},
    {.name = "cowbell",
     .source = "generated cowbell, mouth 104 x 68 mm, 140 mm high, folded of 1.5 mm",
     .material = "Steel",
     .wall = cowbellWall,
     .maxFrequencyHz = 8000,
     .shapeVertexCount = 110,
     .listeners = Listeners::beside,
     .heldAtMetres = {0, 0, 0.14},
     .heldResistanceNsPerM = 20},
    {.name = "brake-drum",
     .source = "generated brake drum, 290 mm wide, 95 mm deep, wall 9 to 14 mm",
     .material = "Iron",
     .section = brakeDrumSection,
     .edgeMetres = 0.02,
     .maxFrequencyHz = 9000,
     .shapeVertexCount = 100,
     .listeners = Listeners::beside},
    {.name = "bottle",
     .source = "generated wine bottle, 290 mm high, 77 mm wide, wall 2.8 to 5 mm",
     .material = "Glass",
     .section = bottleSection,
     .edgeMetres = 0.013,
     .maxFrequencyHz = 12000,
     .shapeVertexCount = 100,
     .listeners = Listeners::beside},
    {.name = "gong",
     .source = "generated gong with a boss, 300 mm wide, rim 40 mm deep, 2.2 to 3.5 mm",
     .material = "Bell bronze",
     .section = gongSection,
     .edgeMetres = 0.015,
     .maxFrequencyHz = 5000,
     .shapeVertexCount = 110},
    {.name = "church-bell",
     .source = "generated church bell, about 1 m wide, with a minor third",
     .material = "Bell bronze",
     .section = churchBellSection,
     .edgeMetres = 0.06,
     .maxFrequencyHz = 4500,
     .shapeVertexCount = 110,
     .listeners = Listeners::beside},
    {.name = "temple-block",
     .source = "generated temple block, 122 x 87 mm, wall 5 to 16 mm, with its cavity",
     .material = "Wood",
     .wall = templeBlockWall,
     .isSlit = isTempleBlockSlit,
     .maxFrequencyHz = 9000,
     .shapeVertexCount = 90},
    {.name = "wood-block",
     .source = "generated wood block, 180 x 100 x 32 mm, top 5 mm, bottom 19 mm, with its cavity",
     .material = "Maple",
     .wall = woodBlockWall,
     .isSlit = isWoodBlockSlit,
     .maxFrequencyHz = 12000,
     .shapeVertexCount = 100},
    {.name = "sleigh-bell",
     .source = "generated sleigh bell, 29 mm wide, 1.1 mm, with its cavity",
     .material = "Brass",
     .wall = sleighBellWall,
     .isSlit = isSleighBellSlit,
     .maxFrequencyHz = 22000,
     .shapeVertexCount = 90,
     .listeners = Listeners::beside},
};

} // namespace

std::span<const FactoryShape> factoryShells() {
    return shells;
}

} // namespace idiophone
