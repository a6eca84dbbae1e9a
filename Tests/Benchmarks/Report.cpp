#include "Benchmarks/Report.h"

#include "Benchmarks/Peak.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace idiophone {
namespace {

const char* relation(const BenchGoal& goal) {
    return goal.kind == BenchGoal::Kind::atLeast ? "at least" : "at most";
}

void printGoals(std::ostream& text, const std::vector<BenchGoal>& goals) {
    for (const BenchGoal& goal : goals)
        text << (goal.met() ? "  met     " : "  NOT MET ") << goal.name << ": "
             << figure(goal.measured) << ", goal " << relation(goal) << ' ' << figure(goal.bound)
             << '\n';
}

} // namespace

std::string figure(double value, int digits) {
    std::ostringstream text;
    const double size = std::abs(value);
    if (size >= 1 && size < 1e6) {
        const int whole = static_cast<int>(std::floor(std::log10(size))) + 1;
        text << std::fixed << std::setprecision(std::max(digits - whole, 0));
    } else {
        text << std::setprecision(digits);
    }
    text << value;
    return text.str();
}

std::string benchText(const std::vector<BenchSection>& sections) {
    std::ostringstream text;
    for (const BenchSection& section : sections) {
        text << section.name << ": " << section.title << '\n';
        std::size_t width = 0;
        for (const auto& [what, howMuch] : section.rows)
            width = std::max(width, what.size());
        for (const auto& [what, howMuch] : section.rows)
            text << "  " << std::left << std::setw(static_cast<int>(width) + 2) << what << howMuch
                 << '\n';
        printGoals(text, section.goals);
        text << '\n';
    }
    return text.str();
}

nlohmann::ordered_json benchDocument(const std::vector<BenchSection>& sections) {
    nlohmann::ordered_json goals = nlohmann::ordered_json::array();
    nlohmann::ordered_json benchmarks = nlohmann::ordered_json::object();
    for (const BenchSection& section : sections) {
        for (const BenchGoal& goal : section.goals)
            goals.push_back({{"name", goal.name},
                             {"measured", goal.measured},
                             {"relation", relation(goal)},
                             {"bound", goal.bound},
                             {"met", goal.met()}});
        benchmarks[section.name] = section.figures;
        benchmarks[section.name]["title"] = section.title;
    }
#ifdef __VERSION__
    const char* compiler = __VERSION__;
#else
    const char* compiler = "unknown";
#endif
    return {{"goals", goals},
            {"build", {{"simd_target", simdTarget()}, {"compiler", compiler}}},
            {"benchmarks", benchmarks}};
}

} // namespace idiophone
