// Bars in tune: solves the length of a rectangular bar, modelled as a sheet with the bar's height
// as shell thickness, for the pitch of its lowest bending mode. Undercut bars are another model.
#pragma once

#include "Analysis/ModalAnalysis.h"

namespace idiophone {

struct BarSpecification {
    std::string name;
    double targetFrequencyHz = 440; ///< damped frequency of the lowest bending mode
    double widthMetres = 0.04;
    double heightMetres = 0.02;
    Material material;
    int vertexCount = 1000;     ///< about so many in the mesh
    int shapeVertexCount = 285; ///< about so many carry shapes, on an even grid with the edges
    double maxFrequencyHz = 44000;
};

struct TunedBar {
    double lengthMetres = 0;
    double fundamentalHz = 0;     ///< damped, of the lowest bending mode
    Eigen::Index bendingMode = 0; ///< which mode of the object that is; 0 unless twist lies lower
    Mesh mesh;
    ModalObject object;
};

/// Frequency ratio as 1/100 of an equal-tempered semitone.
double cents(double frequencyHz, double referenceHz);

/// The damped frequency of a mode: √(λ − α²)/2π with α = (γ + η λ)/2; 0 when over-damped.
double dampedFrequencyHz(double eigenvalue, const Material& material);

/// The length at which a free bar has this undamped fundamental, by Timoshenko's theory in the form
/// of ASTM E1876 (eq. 2 and 3); good to about 1 %.
double estimatedBarLengthMetres(const BarSpecification& bar);

/// The vertices of a mesh nearest to the points of an even grid over a centred flat sheet, with its
/// edges, corners, middle and middle lines; ascending. About `count`.
std::vector<int>
evenSheetVertices(const Mesh& sheet, double lengthMetres, double widthMetres, int count);

/// The bar within 0.05 cent of its target, analysed up to `maxFrequencyHz`.
Result<TunedBar> tuneBar(const BarSpecification& bar, const AnalysisControl& control = {});

} // namespace idiophone
