#include "Object/ModalObjectFile.h"
#include "Support/SyntheticObject.h"
#include "Support/TestFolder.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cstring>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <random>

using namespace idiophone;
using Catch::Matchers::ContainsSubstring;
using nlohmann::json;
using test::syntheticObject;

namespace {

std::vector<std::byte> withHeader(const std::string& header,
                                  std::span<const std::byte> data,
                                  std::optional<std::uint64_t> claimedLength = {}) {
    const std::uint64_t length = claimedLength.value_or(header.size());
    std::vector<std::byte> file(8 + header.size());
    std::memcpy(file.data(), &length, 8);
    std::memcpy(file.data() + 8, header.data(), header.size());
    file.insert(file.end(), data.begin(), data.end());
    return file;
}

/// Returns an object of three modes with radiation in two directions at two ratios.
ModalObject radiatingObject() {
    auto object = syntheticObject({100, 200, 300});
    object.radiation = {.directions = {{0.6f, -0.8f, 0}, {0, 0, 1}},
                        .frequencyRatios = {0.1, 3},
                        .weights = {1, -2, 3e-9f, 4, 5, 6, 7, 8, 9, 10, 11, 12}};
    return object;
}

/// Returns a valid file whose header was changed by `change`.
std::vector<std::byte> changed(const std::function<void(json&)>& change,
                               const ModalObject& object = syntheticObject({100, 200, 300})) {
    const auto file = encodeModalObject(object);
    std::uint64_t length = 0;
    std::memcpy(&length, file.data(), 8);
    auto header = json::parse(reinterpret_cast<const char*>(file.data()) + 8,
                              reinterpret_cast<const char*>(file.data()) + 8 + length);
    change(header);
    return withHeader(header.dump(), std::span(file).subspan(8 + length));
}

void checkRefused(std::span<const std::byte> file, const char* sentence) {
    INFO(sentence);
    const auto result = readModalObject(file, "evil.modal");
    REQUIRE_FALSE(result);
    CHECK_THAT(result.error().message, ContainsSubstring("evil.modal"));
    CHECK_THAT(result.error().message, ContainsSubstring(sentence));
}

} // namespace

TEST_CASE("An object read back equals the written one, to the last bit") {
    auto object = syntheticObject({100, 200.125, 44000}, {0.3f, -1.7f, 3e-9f});
    object.bending = {1, 2, 3};
    object.clampedVertices = {0, 2};
    object.decaysPerSecond = {0.3, 7, 1.0 / 3};
    object.material.damping.lossFactor = 1.7e-4;
    object.radiation = radiatingObject().radiation;
    object.provenance = {.source = "a \"mesh\" – ü.obj",
                         .software = "Idiophone",
                         .notes = "line\nline",
                         .analysisSeconds = 0.1,
                         .analysedVertices = 12,
                         .zeroModes = 6};
    const auto file = encodeModalObject(object);
    const auto back = readModalObject(file, "x.modal");
    REQUIRE(back);
    CHECK(back->name == object.name);
    CHECK(back->material == object.material);
    CHECK(back->eigenvalues == object.eigenvalues);
    CHECK(back->shapes == object.shapes);
    CHECK(back->bending == object.bending);
    CHECK(back->clampedVertices == object.clampedVertices);
    CHECK(back->decaysPerSecond == object.decaysPerSecond);
    CHECK(back->radiation == object.radiation);
    CHECK(back->vertices == object.vertices);
    CHECK(back->faces == object.faces);
    CHECK(back->provenance.source == object.provenance.source);
    CHECK(back->provenance.analysisSeconds == object.provenance.analysisSeconds);
    CHECK(encodeModalObject(*back) == file);
}

TEST_CASE("A material without a figure, or with an invalid one, is refused") {
    const auto withMaterial = [](const std::function<void(json&)>& change) {
        return changed([&](json& header) {
            auto& text = header["__metadata__"]["material"];
            auto material = json::parse(text.get<std::string>());
            change(material);
            text = material.dump();
        });
    };
    checkRefused(withMaterial([](json& m) { m.erase("loss_factor"); }), "'loss_factor'");
    checkRefused(withMaterial([](json& m) { m["loss_factor"] = "much"; }), "'loss_factor'");
    checkRefused(withMaterial([](json& m) { m["loss_factor"] = -1; }), "loss factor");
}

TEST_CASE("Half-precision shapes are within half a unit of the eleventh bit") {
    const auto object = syntheticObject({100, 200, 300}, {0.3f, -1.7f, 12.345f});
    const auto back = readModalObject(encodeModalObject(object, ShapePrecision::half), "x.modal");
    REQUIRE(back);
    for (std::size_t i = 0; i < object.shapes.size(); ++i)
        CHECK(std::abs(back->shapes[i] - object.shapes[i]) <= std::abs(object.shapes[i]) / 2048);
}

TEST_CASE("Shapes that half precision cannot hold are written in single precision") {
    const auto object = syntheticObject({100, 200}, {65'520, -largestShape});
    const auto back = readModalObject(encodeModalObject(object, ShapePrecision::half), "x.modal");
    REQUIRE(back);
    CHECK(back->shapes == object.shapes);
}

TEST_CASE("A file written to disk is read back, and an unwritable place gives one sentence") {
    const auto directory = test::testFolder();
    const auto file = directory / "written.modal";
    REQUIRE(writeModalObject(syntheticObject({100}), file));
    CHECK(readModalObject(file));
    std::filesystem::remove(file);
    const auto failed = writeModalObject(syntheticObject({100}), directory / "none" / "x.modal");
    REQUIRE_FALSE(failed);
    CHECK_THAT(failed.error().message, ContainsSubstring("cannot be written"));
    const auto missing = readModalObject(directory / "missing.modal");
    REQUIRE_FALSE(missing);
    CHECK_THAT(missing.error().message, ContainsSubstring("missing.modal"));
    CHECK_FALSE(readModalObject(directory));
}

TEST_CASE("Writing an object leaves the files beside it unchanged, whatever their names") {
    const auto directory = test::testFolder() / "beside";
    std::filesystem::remove_all(directory);
    std::filesystem::create_directories(directory);
    for (const auto* name : {"x.modal.part", "x.modal.1.part", "x.modal.2.part"})
        std::ofstream(directory / name) << "theirs";
    REQUIRE(writeModalObject(syntheticObject({100}), directory / "x.modal"));
    CHECK(readModalObject(directory / "x.modal"));
    for (const auto* name : {"x.modal.part", "x.modal.1.part", "x.modal.2.part"}) {
        std::ifstream file(directory / name);
        CHECK(std::string(std::istreambuf_iterator<char>(file), {}) == "theirs");
    }
    using Files = std::filesystem::directory_iterator;
    CHECK(std::distance(Files(directory), Files()) == 4);
}

TEST_CASE("A file with the longest valid texts is read back, and longer texts are refused") {
    auto object = syntheticObject({100});
    object.provenance.notes = std::string(120'000, '\x01'); // seven bytes each in the file
    REQUIRE(validated(object));
    const auto file = test::testFolder() / "texts.modal";
    REQUIRE(writeModalObject(object, file));
    const auto back = readModalObject(file);
    REQUIRE(back);
    CHECK(back->provenance.notes == object.provenance.notes);
    object.provenance.notes.append(80'000, '\x01');
    CHECK_THAT(validated(object).error().message, ContainsSubstring("its texts are longer"));
    const auto other = test::testFolder() / "longer.modal";
    const auto refused = writeModalObject(object, other);
    REQUIRE_FALSE(refused);
    CHECK_THAT(refused.error().message, ContainsSubstring("longer.modal: the object's texts"));
    CHECK_FALSE(std::filesystem::exists(other));
}

TEST_CASE("A hostile header is refused with its fault") {
    checkRefused({}, "too short");
    checkRefused(withHeader("{}", {}, std::uint64_t{1} << 60), "it is not a modal object");
    checkRefused(withHeader("{}", {}, 100), "cut off");
    checkRefused(withHeader("[1, 2", {}), "not a JSON object");
    checkRefused(withHeader(std::string(900'000, '['), {}), "not a JSON object");
    checkRefused(withHeader("{}", {}), "not an Idiophone modal object");
    checkRefused(changed([](json& h) { h["__metadata__"]["format_version"] = "2"; }), "version 2");
    checkRefused(changed([](json& h) { h["__metadata__"].erase("material"); }), "'material'");
    checkRefused(changed([](json& h) { h["__metadata__"]["mass"] = "{}"; }), "'mass_kg'");
    checkRefused(changed([](json& h) { h["__metadata__"]["body"] = "ghost"; }), "ghost");
}

TEST_CASE("A hostile tensor is refused with its fault") {
    using Change = std::function<void(json&)>;
    const auto [change, sentence] = GENERATE(table<Change, const char*>({
        {[](json& h) { h["faces"]["data_offsets"][0] = 0; }, "does not match its shape"},
        {[](json& h) {
             h["faces"]["data_offsets"] = h["vertices"]["data_offsets"];
             h["faces"]["shape"] = {4, 3};
         },
         "overlap"},
        {[](json& h) {
             h["faces"]["shape"] = {-2, 3};
         },
         "whole positive"},
        {[](json& h) {
             h["faces"]["shape"] = {1ull << 62, 1ull << 62};
         },
         "more data than"},
        {[](json& h) { h["faces"]["data_offsets"][1] = 1ull << 60; }, "outside the file"},
        {[](json& h) { h["faces"]["dtype"] = "F32"; }, "not of type I32"},
        {[](json& h) { h["faces"]["dtype"] = "X99"; }, "unknown number type"},
        {[](json& h) { h["faces"]["shape"] = {6}; }, "right shape"},
        {[](json& h) { h["faces"].erase("dtype"); }, "not described"},
        {[](json& h) { h["eigenvalues"]["data_offsets"] = "x"; }, "not described"},
        {[](json& h) { h.erase("shapes"); }, "after its last tensor"},
        {[](json& h) {
             h["shapes"]["shape"] = {2, 6, 3};
         },
         "size of the mode shapes"},
    }));
    checkRefused(changed(change), sentence);
}

TEST_CASE("A hostile radiation table is refused with its fault") {
    using Change = std::function<void(json&)>;
    const auto rename = [](const char* name) {
        return [name](json& h) {
            h["other"] = h[name];
            h.erase(name);
        };
    };
    const auto reshape = [](const char* name, const json& shape) {
        return [name, shape](json& h) { h[name]["shape"] = shape; };
    };
    const auto [change, sentence] = GENERATE_COPY(table<Change, const char*>({
        {rename("radiation"), "lacks the tensor 'radiation'"},
        {rename("radiation_directions"), "lacks the tensor 'radiation_directions'"},
        {rename("radiation_ratios"), "lacks the tensor 'radiation_ratios'"},
        {[](json& h) { h["radiation"]["dtype"] = "I32"; }, "of type F32"},
        {[](json& h) { h["radiation_directions"]["dtype"] = "I32"; }, "not of type F32"},
        {[](json& h) { h["radiation_ratios"]["dtype"] = "I64"; }, "not of type F64"},
        {reshape("radiation", {24}), "right shape"},
        {reshape("radiation_directions", {3, 2}), "right shape"},
        {reshape("radiation_ratios", {1, 2}), "right shape"},
        {reshape("radiation", {2, 3, 2, 2}), "directions x ratios x modes"},
        {reshape("radiation", {1, 4, 3, 2}), "directions x ratios x modes"},
        {reshape("radiation", {4, 1, 3, 2}), "directions x ratios x modes"},
        {reshape("radiation", {2, 2, 6, 1}), "real and imaginary parts"},
        {reshape("radiation", {2, 2, 1ull << 62, 2}), "more data than"},
    }));
    checkRefused(changed(change, radiatingObject()), sentence);

    auto object = radiatingObject();
    object.radiation.directions[1] = {0, 0, 0.9f};
    checkRefused(encodeModalObject(object), "not a unit vector");
    object = radiatingObject();
    object.radiation.frequencyRatios = {3, 0.1};
    checkRefused(encodeModalObject(object), "not in ascending order");
    object = radiatingObject();
    object.radiation.weights[5] = std::numeric_limits<float>::infinity();
    checkRefused(encodeModalObject(object), "not a number up to 1e8");
}

TEST_CASE("An empty radiation table with tensors is refused") {
    const auto file = changed([](json& h) {
        h["radiation"] = {{"dtype", "F32"}, {"shape", {0, 0, 3, 2}}, {"data_offsets", {0, 0}}};
        h["radiation_directions"] = {{"dtype", "F32"}, {"shape", {0, 3}}, {"data_offsets", {0, 0}}};
        h["radiation_ratios"] = {{"dtype", "F64"}, {"shape", {0}}, {"data_offsets", {0, 0}}};
    });
    checkRefused(file, "directions x ratios x modes");
}

TEST_CASE("The reader refuses the same invalid values as the validation") {
    auto object = syntheticObject({100, 200});
    object.eigenvalues[1] = std::numeric_limits<double>::quiet_NaN();
    checkRefused(encodeModalObject(object), "not a finite number");
}

TEST_CASE("No truncation and no flipped byte crashes the reader") {
    const auto file = encodeModalObject(radiatingObject());
    for (std::size_t size = 0; size < file.size(); ++size)
        CHECK_FALSE(readModalObject(std::span(file).first(size), "cut.modal"));
    std::mt19937 random(1);
    for (int round = 0; round < 20000; ++round) {
        auto damaged = file;
        for (int flips = 0; flips < 3; ++flips)
            damaged[random() % damaged.size()] = static_cast<std::byte>(random());
        const auto result = readModalObject(damaged, "damaged.modal");
        if (!result)
            REQUIRE(result.error().message.starts_with("damaged.modal: "));
    }
}

TEST_CASE("A header nested half a million deep is refused without exhausting the stack") {
    const auto deep = std::string(500000, '[') + std::string(500000, ']');
    checkRefused(withHeader(R"({"__metadata__":)" + deep + "}", {}), "not a JSON object");
    checkRefused(withHeader(R"({"shapes":)" + deep + "}", {}), "not a JSON object");
}

TEST_CASE("Texts of a header fit on one line in the error") {
    const auto oneLineOnly = [](const std::string& name, const json& entry) {
        const auto object =
            readModalObject(changed([&](json& header) { header[name] = entry; }), "evil.modal");
        REQUIRE_FALSE(object);
        CHECK(object.error().message.find('\n') == std::string::npos);
        CHECK(object.error().message.size() < 250);
    };
    oneLineOnly("two\nlines", 7);
    oneLineOnly(std::string(5000, 'x'), 7);
    oneLineOnly("x", {{"dtype", "F\n64"}, {"shape", {1}}, {"data_offsets", {0, 8}}});
    for (const char* key : {"body", "format_version"})
        checkRefused(changed([&](json& header) { header["__metadata__"][key] = "two\nlines"; }),
                     "two?lines");
    auto object = syntheticObject({100, 200, 300});
    object.material.name = "two\nlines";
    object.material.densityKgPerM3 = -1;
    checkRefused(encodeModalObject(object), "material 'two?lines': the density");
}
