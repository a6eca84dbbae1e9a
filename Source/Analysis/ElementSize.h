// How fine elements must be for a band of frequencies, and which meshes are as fine. Sizes in
// elements a wavelength are for quadratic tetrahedra only.
#pragma once

#include "Analysis/ElasticLaw.h"
#include "Geometry/Mesh.h"

namespace idiophone {

/// The shortest wavelength that a body of this wall (MeshCheck) carries at a frequency: the bending
/// wave of Timoshenko's beam (lower branch, κ = 5/6) with the law's least Young's modulus and
/// slowest shear wave. Low down that is √(2π h/f) (E/12ρ)^¼; high up it tends to 0.91 c_s/f, nearly
/// a Rayleigh wave.
double shortestWavelengthMetres(const ElasticLaw& law,
                                double densityKgPerM3,
                                double frequencyHz,
                                double wallThicknessMetres);

/// The highest frequency up to `maxFrequencyHz` whose shortest wavelength is no shorter than that.
double servedFrequencyHz(const ElasticLaw& law,
                         double densityKgPerM3,
                         double maxFrequencyHz,
                         double wallThicknessMetres,
                         double wavelengthMetres);

/// Elements a wavelength where two or more lie across the wall; the error of a frequency falls
/// with the fourth power.
inline constexpr double elementsPerWavelengthInSolids = 4;

/// Elements a wavelength where a single one lies across the wall. Then its curvature is constant,
/// as u = −z w′ with quadratic w′ is cubic, and the error falls with the square only.
inline constexpr double elementsPerWavelengthInWalls = 10;

/// Flatter elements than this (edge over wall) lock.
inline constexpr double flattestElement = 4;

/// The edge at which the highest modes of the band are within about 1 % of those of an endlessly
/// fine mesh, the lower ones nearer (docs/validation.md). For 0.5 % divide it by 1.4 (in solids
/// by 1.2).
double targetEdgeMetres(const ElasticLaw& law,
                        double densityKgPerM3,
                        double maxFrequencyHz,
                        double wallThicknessMetres);

/// Between these shares of the edge wanted a surface is left as it is, for solids and shells.
inline constexpr double finestEdgeShare = 0.4, coarsestEdgeShare = 1.6;

/// Triangles that remeshing may make on its way (of long needles) beyond those that the mesh has;
/// more take minutes and gigabytes.
inline constexpr double mostNewTriangles = 100000;

} // namespace idiophone
