#include "Instrument/ImpulseLine.h"
#include "Object/FileBytes.h"

#include <catch2/catch_test_macros.hpp>
#include <nlohmann/json.hpp>

using namespace idiophone;

namespace fs = std::filesystem;

TEST_CASE("A strike is one line of JSON with its time, object, place and impulse") {
    const PlacedImpact impact{
        .seconds = 1.25,
        .slot = 3,
        .strike = {.point = {}, .impulseNewtonSeconds = {0, 0.5f, -2}, .durationSeconds = 0.002},
        .pointMetres = {0.1, 0.2, -0.3}};
    const auto text = impulseLine("coin.modal", 1, impact);
    CHECK(text.find('\n') == text.size() - 1);
    const auto line = nlohmann::json::parse(text);
    CHECK(line["time"] == 1.25);
    CHECK(line["object"] == "coin.modal");
    CHECK(line["body"] == 3);
    CHECK(line["point"] == nlohmann::json({0.1, 0.2, -0.3}));
    CHECK(line["impulse"] == nlohmann::json({0, 0.5, -2}));
    CHECK(line["contact_time"] == 0.002);
    CHECK_FALSE(line.contains("size"));

    CHECK(nlohmann::json::parse(impulseLine("coin.modal", 2, impact))["size"] == 2);
}

TEST_CASE("A list names files in its folder by relative paths, and other files by full paths") {
    const auto here = fs::current_path();
    const auto list = here / "lists" / "impacts.jsonl";
    const auto named = [&](const fs::path& file) { return objectInList(nameOf(file), list); };
    CHECK(objectInList("xylophone-72", list) == "xylophone-72");
    CHECK(named(here / "lists" / "coin.modal") == "coin.modal");
    CHECK(named(here / "lists" / "more" / ".." / "x" / "coin.modal") == "x/coin.modal");
    CHECK(named("lists/coin.modal") == "coin.modal");
    CHECK(objectInList("coin.modal", "impacts.jsonl") == "coin.modal");
    CHECK(named(here / "coin.modal") == storedNameOf(here / "coin.modal"));
    CHECK(named("coin.modal") == storedNameOf(here / "coin.modal"));
    // A path names the file, even if a factory object has its name.
    CHECK(named(here / "lists" / "plate") == storedNameOf(here / "lists" / "plate"));
}
