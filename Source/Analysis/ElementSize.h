// The element size that a frequency band needs. Sizes in elements per wavelength hold for quadratic
// tetrahedra only.
#pragma once

#include "Analysis/ElasticLaw.h"
#include "Mesh/Mesh.h"

namespace idiophone {

/// Returns the shortest wavelength at a frequency in a body with this wall thickness (MeshCheck).
/// It is the bending wave of a Timoshenko beam (lower branch, κ = 5/6) with the law's minimum
/// Young's modulus and slowest shear wave. At low frequencies it is √(2π h/f) (E/12ρ)^¼. At high
/// frequencies it tends to 0.91 c_s/f, nearly a Rayleigh wave.
double shortestWavelengthMetres(const ElasticLaw& law,
                                double densityKgPerM3,
                                double frequencyHz,
                                double wallThicknessMetres);

/// Returns the highest frequency up to `maxFrequencyHz` whose shortest wavelength is at least
/// `wavelengthMetres`.
double servedFrequencyHz(const ElasticLaw& law,
                         double densityKgPerM3,
                         double maxFrequencyHz,
                         double wallThicknessMetres,
                         double wavelengthMetres);

/// Elements per wavelength if two or more lie across the wall. The frequency error falls with the
/// fourth power.
inline constexpr double elementsPerWavelengthInSolids = 4;

/// Elements per wavelength if one lies across the wall. u = −z w′ with quadratic w′ is cubic, so
/// the element's curvature is constant. The error falls with the square only.
inline constexpr double elementsPerWavelengthInWalls = 10;

/// Ratio of edge to 2V/A in a rod, up to which it twists within 0.3 % of a very fine mesh. In a
/// square section, 2.3 elements lie side by side. The error falls with the fourth power.
inline constexpr double twistingElement = 0.87;

/// Maximum ratio of edge to wall thickness; flatter elements lock.
inline constexpr double flattestElement = 4;

/// Returns the edge for which the highest modes of the band are within about 1 % of a very fine
/// mesh (docs/validation.md). Lower modes are more exact. For 0.5 %, divide the edge by 1.4 (in
/// solids by 1.2).
double targetEdgeMetres(const ElasticLaw& law,
                        double densityKgPerM3,
                        double maxFrequencyHz,
                        double wallThicknessMetres);

/// A surface is not remeshed if its edges lie between these shares of the target edge.
inline constexpr double finestEdgeShare = 0.4, coarsestEdgeShare = 1.6;

/// Maximum number of triangles that remeshing may add for long needles. More would take minutes and
/// gigabytes.
inline constexpr double maximumNewTriangles = 100000;

} // namespace idiophone
