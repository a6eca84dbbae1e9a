// No version is released without its golden states and names (docs/decisions/0026-old-projects.md).
#include "Plugin/GoldenFolder.h"

#include <vector>

using namespace idiophone;
using namespace idiophone::test;

namespace {

/// Those of the changelog's headings that are not "(unreleased)".
std::vector<std::string> releasedVersions(const std::string& changelog) {
    const std::string heading = "## ";
    std::vector<std::string> versions;
    std::istringstream lines(changelog);
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with(heading) && line.find("(unreleased)") == std::string::npos)
            versions.push_back(
                line.substr(heading.size(), line.find(' ', heading.size()) - heading.size()));
    return versions;
}

/// What a version's folder should have and does not.
std::vector<std::string> missingOf(const std::string& version) {
    const auto folder = goldenFolder / version;
    std::vector<std::string> missing;
    for (const char* names : {"names.txt", "vst3.txt"}) // the second one is test_validators.py's
        if (!std::filesystem::exists(folder / names))
            missing.push_back(names);
    std::vector<std::filesystem::path> states;
    if (std::filesystem::exists(folder))
        for (const auto& entry : std::filesystem::directory_iterator(folder))
            if (entry.path().extension() == ".state")
                states.push_back(entry.path());
    for (const auto& take : goldenTakes) {
        int waves = 0;
        for (const auto& state : states)
            waves += std::filesystem::exists(waveOf(state, take)) ? 1 : 0;
        if (waves < take.least)
            missing.push_back(std::string("waves of states as NAME") + take.ending);
    }
    return missing;
}

using Names = std::vector<std::string>;

} // namespace

TEST_CASE("Every version that the changelog has as released has its golden states and names") {
    const auto changelog = bytesOf(std::filesystem::path(IDIOPHONE_SOURCE_DIR) / "CHANGELOG.md");
    CHECK(changelog.find("## ") != std::string::npos);
    for (const auto& version : releasedVersions(changelog)) {
        INFO(version << ": `IDIOPHONE_MAKE_GOLDEN=1 test_plugin \"[make-golden]\"` makes them");
        CHECK(missingOf(version) == Names{});
    }
    CHECK(missingOf("0.1.0") == Names{});
}

TEST_CASE("A release without golden states and names is noticed") {
    CHECK(releasedVersions("# Changelog\n\n## 0.3.0 (unreleased)\n\n- ## no\n\n"
                           "## 0.2.1 (2031-05-01)\n\n- one\n\n## 0.2.0\n") ==
          Names{"0.2.1", "0.2.0"});
    CHECK(missingOf("no version").size() == 2 + goldenTakes.size());
}
