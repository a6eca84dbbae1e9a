// The tables of docs/validation.md: each case checks its own results and that the page shows them.
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace idiophone::test {

inline constexpr std::array<std::string_view, 19> validationTitles{
    "Free bar, finite elements",
    "Free bar, two-layer springs",
    "Free square plate, finite elements",
    "Free square plate, two-layer springs",
    "Free circular plate, finite elements",
    "Free circular plate, two-layer springs",
    "Free circular plate of half the thickness, finite elements",
    "Free plate of 1.5 to 1, finite elements",
    "Ring in its plane, finite elements",
    "Ring in its plane, two-layer springs",
    "Cantilever, finite elements",
    "Cantilever, two-layer springs",
    "Square cantilever plate, finite elements",
    "Stretch and twist of a round bar, finite elements",
    "Hollow sphere, finite elements",
    "Hollow sphere, two-layer springs",
    "Wooden bar along the grain, finite elements",
    "Wooden bar across the grain, finite elements",
    "Free square plate as a user's mesh is cut, finite elements"};

struct ValidationRow {
    std::string mode;
    double theoryHz = 0;
    double foundHz = 0;
};

struct ValidationCase {
    std::string title; ///< one of `validationTitles`
    std::string text;  ///< the body, the theory and its source, the mesh
    double tolerance = 0;
    Eigen::Index unknowns = 0;
    std::vector<ValidationRow> rows;
};

/// Checks every row against the tolerance, writes the section into the build tree, and checks that
/// the page shows the same digits. The last digit may differ by a unit or two, because compilers
/// round differently. With IDIOPHONE_WRITE_VALIDATION set in the environment, writes the page
/// instead.
void report(const ValidationCase& validation);

std::vector<std::string> validationHeadings();

} // namespace idiophone::test
