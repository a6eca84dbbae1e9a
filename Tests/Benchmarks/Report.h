// The results of benchmarks: figures for machines, rows for people, and goals met or missed.
// Independent of what is measured.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

namespace idiophone {

/// A measured ratio and the bound that the project sets.
struct BenchGoal {
    enum class Kind { atLeast, atMost };

    std::string name;
    double measured = 0;
    Kind kind = Kind::atLeast;
    double bound = 0;

    bool met() const { return kind == Kind::atLeast ? measured >= bound : measured <= bound; }
};

struct BenchSection {
    std::string name;  ///< as on the command line
    std::string title; ///< measured quantity, in plain words
    /// Quantity, and value with its unit.
    std::vector<std::pair<std::string, std::string>> rows = {};
    nlohmann::ordered_json figures = nlohmann::ordered_json::object();
    std::vector<BenchGoal> goals = {};

    void row(std::string what, std::string howMuch) {
        rows.emplace_back(std::move(what), std::move(howMuch));
    }
};

/// Formats a number with `digits` significant digits, without powers of ten below a million.
std::string figure(double value, int digits = 3);

/// Formats titles, aligned rows and goals.
std::string benchText(const std::vector<BenchSection>& sections);

/// Returns `goals` at the top level (name, measured, relation "at least" or "at most", bound, met).
/// The SIMD target and the compiler are under `build`, and the figures of each benchmark are under
/// `benchmarks`.
nlohmann::ordered_json benchDocument(const std::vector<BenchSection>& sections);

} // namespace idiophone
