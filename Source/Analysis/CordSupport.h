// The two cords or felts that carry a bar, and the loss that they add to each of its modes.
#pragma once

#include "Object/ModalObject.h"

#include <vector>

namespace idiophone {

/// Each cord resists the bar's vertical velocity v with the force R v, R = R₁ (f/1 kHz)ⁿ. The cords
/// lie near the nodes of the fundamental, so that they damp the other partials more.
///
/// The defaults are a fit to the bending partials of three recorded glockenspiel bars, within a
/// factor of 1.6 each (docs/materials.md).
struct CordSupport {
    double resistanceNsPerM = 2.0; ///< R₁ ≥ 0, of one cord at 1 kHz
    /// n, −1 to 0. 0 is a dashpot, −1 a spring with a constant loss factor.
    double resistanceExponent = 0;
    /// Distance of a cord's contact from the fundamental's node, over the bar's length, 0 to 0.1.
    double spreadOverLength = 0.06;
};

/// Returns where the nodes of the fundamental cross the middle line of the top: x in metres from
/// the bar's middle, ascending. A bar has two. The result is empty if the bar has no bending mode.
/// `bar` is a tuned bar's object (BarTuning.h).
std::vector<double> cordPlacesMetres(const ModalObject& bar);

/// Adds the cords' loss to each mode's decay: Δα = R(f)/2 Σ φ², at the mode's own frequency, summed
/// over the cords. φ² is the squared vertical shape, averaged over the bar's width and over both
/// sides of the node at the spread's distance. `bar` is a tuned bar's object. Does nothing unless
/// the bar has exactly two nodes.
void addCordLoss(ModalObject& bar, const CordSupport& cords);

} // namespace idiophone
