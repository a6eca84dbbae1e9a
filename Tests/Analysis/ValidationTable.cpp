#include "ValidationTable.h"

#include "Object/NumberText.h"

#include <algorithm>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

namespace idiophone::test {
namespace {

const std::filesystem::path page =
    std::filesystem::path(IDIOPHONE_SOURCE_DIR) / "docs/validation.md";

std::string textOf(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::string formatted(const char* format, double value) {
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), format, value);
    return text.data();
}

std::string
tableOf(double tolerance, Eigen::Index unknowns, const std::vector<ValidationRow>& rows) {
    std::string table = "Asked: within " + formatted("%g", 100 * tolerance) + " %. " +
                        std::to_string(unknowns) +
                        " unknowns.\n\n| mode | theory Hz | found Hz | error % |\n"
                        "|---|---|---|---|\n";
    for (const auto& row : rows)
        table += "| " + row.mode + " | " + formatted("%.5g", row.theoryHz) + " | " +
                 formatted("%.5g", row.foundHz) + " | " +
                 formatted("%+.2f", 100 * (row.foundHz / row.theoryHz - 1)) + " |\n";
    return table + "\n";
}

/// Returns the range of a section's figures in the page: from "Asked" to the next heading or the
/// end.
std::pair<std::size_t, std::size_t> placeOf(const std::string& title, const std::string& text) {
    const auto heading = text.find("## " + title + "\n");
    REQUIRE(heading != std::string::npos);
    const auto end = std::min(text.find("\n## ", heading), text.size() - 1) + 1;
    const auto begin = text.find("Asked: ", heading);
    REQUIRE(begin < end);
    return {begin, end};
}

std::vector<std::string> wordsOf(const std::string& text) {
    std::istringstream stream(text);
    return {std::istream_iterator<std::string>(stream), {}};
}

/// Meshers decide by rounding, so processors and systems differ by some elements.
bool pageIsCurrent(const std::string& shown, const std::string& now) {
    const auto a = wordsOf(shown), b = wordsOf(now);
    if (a.size() != b.size())
        return false;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const auto x = parseNumber(a[i]), y = parseNumber(b[i]);
        const double tolerance = i + 1 < a.size() && a[i + 1] == "unknowns." ? 0.02 : 2e-4;
        const bool same =
            x && y ? std::abs(*x - *y) <= std::max(0.03, tolerance * std::abs(*x)) : a[i] == b[i];
        if (!same)
            return false;
    }
    return true;
}

} // namespace

void report(const std::string& title,
            double tolerance,
            const SolvedBody& body,
            const std::vector<ValidationRow>& rows) {
    for (const auto& row : rows) {
        INFO(row.mode << ": theory " << row.theoryHz << " Hz, found " << row.foundHz << " Hz");
        CHECK(std::abs(row.foundHz / row.theoryHz - 1) <= tolerance);
    }
    const std::string table = tableOf(tolerance, body.model.stiffness.rows(), rows);
    const auto folder = std::filesystem::path(IDIOPHONE_TEST_DIR) / "validation";
    std::filesystem::create_directories(folder);
    std::ofstream(folder / (title + ".md"), std::ios::binary) << table;
    const std::string text = textOf(page);
    const auto [begin, end] = placeOf(title, text);
    if (std::getenv("IDIOPHONE_WRITE_VALIDATION") != nullptr) {
        std::ofstream(page, std::ios::binary) << text.substr(0, begin) + table + text.substr(end);
        return;
    }
    INFO("Now:\n" << table << "On the page:\n" << text.substr(begin, end - begin));
    CHECK(pageIsCurrent(text.substr(begin, end - begin), table));
}

std::size_t validationSections() {
    std::istringstream text(textOf(page));
    std::size_t sections = 0;
    for (std::string line; std::getline(text, line);)
        sections += line.starts_with("## ") ? 1 : 0;
    return sections;
}

} // namespace idiophone::test
