// The tables of docs/validation.md: each case checks its own results and that the page shows them.
#pragma once

#include "SolvedBody.h"

#include <string>
#include <vector>

namespace idiophone::test {

struct ValidationRow {
    std::string mode;
    double theoryHz = 0;
    double foundHz = 0;
};

/// Checks every row against the tolerance, writes the table into the build tree, and checks that
/// the page's section of this title shows the same digits after "Asked". The last digit may differ
/// by a unit or two, because compilers round differently. With IDIOPHONE_WRITE_VALIDATION set in
/// the environment, writes the figures to the page instead. The text before them belongs to the
/// page.
void report(const std::string& title,
            double tolerance,
            const SolvedBody& body,
            const std::vector<ValidationRow>& rows);

std::size_t validationSections();

} // namespace idiophone::test
