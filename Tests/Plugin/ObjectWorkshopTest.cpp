// Workshop jobs from file to object, and all the ways in which they end early.
#include "Support/ImportedFiles.h"

#include "Geometry/ParametricMesh.h"
#include "Gltf/ObjectGlb.h"
#include "Object/ModalObjectFile.h"
#include "Plugin/ImportChoices.h"
#include "Plugin/ObjectWorkshop.h"
#include "Support/GltfFile.h"
#include "Support/SyntheticObject.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Matchers::ContainsSubstring;
using ImportStage = ImportStatus::Stage;

namespace {

std::vector<ObjectWorkshop::Product> productsOf(ObjectWorkshop& workshop) {
    std::vector<ObjectWorkshop::Product> products;
    const auto take = [&] {
        if (auto product = workshop.takeProduct())
            products.push_back(std::move(*product));
    };
    waitUntil([&] { return !workshop.status().isWorking(); }, take);
    take();
    return products;
}

/// Returns once the job has come as far as `progress`, 0 to 1, or is over.
void waitForProgress(const ObjectWorkshop& workshop, double progress) {
    waitUntil([&] {
        const auto status = workshop.status();
        return !status.isWorking() || status.progress >= progress;
    });
}

} // namespace

TEST_CASE("A mesh becomes a preview and then the object, with its guessed unit and its notes") {
    const auto file = smallPlateFile("plate.obj", 1000);
    ObjectWorkshop workshop;
    CHECK(workshop.status().stage == ImportStage::none);
    workshop.open(file, {});
    CHECK(workshop.status().isWorking());
    CHECK(workshop.status().fileName == "plate.obj");
    const auto products = productsOf(workshop);
    const auto status = workshop.status();
    CHECK(status.error.empty());
    REQUIRE(status.stage == ImportStage::done);
    CHECK(status.progress == 1);
    CHECK(status.unit == "mm");
    CHECK(status.method == "two-layer");
    CHECK_THAT(status.notes, ContainsSubstring("looks like millimetres"));
    CHECK_THAT(status.notes, ContainsSubstring("Taken as a shell of 2 mm"));
    CHECK_THAT(status.summary, ContainsSubstring("of Steel, 60 x 36 x 0 mm"));
    REQUIRE_FALSE(products.empty());
    const auto& last = products.back();
    CHECK_FALSE(last.isPreview);
    CHECK(last.isNewFile);
    CHECK(products.front().isFirst);
    CHECK(last.object->modeCount() > 5);
    CHECK(last.object->thicknessMetres == 0.002);
}

TEST_CASE("What is odd in a mesh file is in the notes, also if the object is refused") {
    ObjectWorkshop workshop;
    workshop.open(writtenFile("far.obj",
                              "v 5000 0 0\nv 5000.06 0 0\nv 5000.06 0.03 0\nv 5000 0.03 0\n"
                              "f 1 2 3 4\n"),
                  {});
    CHECK_FALSE(productsOf(workshop).empty());
    CHECK_THAT(workshop.status().notes, ContainsSubstring("Moved the mesh to the origin"));
    workshop.open(writtenFile("far-line.obj", "v 5000 0 0\nv 5001 0 0\nv 5002 0 0\nf 1 2 3\n"), {});
    CHECK(productsOf(workshop).empty());
    CHECK_THAT(workshop.status().error, ContainsSubstring("no face with an area") &&
                                            ContainsSubstring("Moved the mesh to the origin"));
}

TEST_CASE("The preview comes first and is close in pitch") {
    ObjectWorkshop workshop;
    std::vector<double> lowest;
    std::vector<bool> previews;
    // If the system suspends this thread, the whole object may replace the preview.
    for (int attempt = 0; attempt < 20 && previews.size() < 2; ++attempt) {
        lowest.clear();
        previews.clear();
        workshop.open(smallPlateFile("plate.ply", 1), {});
        for (const auto& product : productsOf(workshop)) {
            lowest.push_back(std::sqrt(product.object->eigenvalues.front()));
            previews.push_back(product.isPreview);
        }
    }
    REQUIRE(previews == std::vector{true, false});
    CHECK(std::abs(lowest[0] / lowest[1] - 1) < 0.05);
}

TEST_CASE("A file without a usable object is refused in a sentence that names it") {
    const auto folder = testFolder();
    const auto garbage = writtenFile("garbage.obj", "f 1 2 3 \x01\x02 not a mesh\nv nan x\n");
    const std::vector<std::pair<std::filesystem::path, std::string>> cases{
        {garbage, "garbage.obj"},
        {folder / "missing.stl", "missing.stl"},
        {writtenFile("empty.ply", ""), "empty.ply"},
        {writtenFile("empty.obj", "# nothing\n"), "empty.obj"},
        {writtenFile("point.obj", "v 0 0 0\nv 0 0 0\nv 0 0 0\nf 1 2 3\n"), "point.obj"},
        {writtenFile("huge.stl", std::string(80, 'x').append("\xff\xff\xff\x7f")), "huge.stl"},
        {writtenFile("noise.modal", std::string(64, '\xff')), "noise.modal"},
        {writtenFile("song.mid", "MThd"), "song.mid"},
        {folder, folder.filename().string()},
    };
    ObjectWorkshop workshop;
    for (const auto& [file, name] : cases) {
        INFO(file);
        workshop.open(file, {});
        CHECK(productsOf(workshop).empty());
        const auto status = workshop.status();
        CHECK(status.stage == ImportStage::failed);
        CHECK_THAT(status.error, ContainsSubstring(name));
    }
}

TEST_CASE("A mesh is scaled to the longest side that is given, whatever its unit") {
    ObjectWorkshop workshop;
    workshop.open(smallPlateFile("plate.obj", 1000), {.longestMetres = 0.05});
    const auto products = productsOf(workshop);
    REQUIRE_FALSE(products.empty());
    const auto status = workshop.status();
    CHECK(status.unit == "mm");
    CHECK(std::abs(status.sidesMetres[0] - 0.05) < 1e-6);
    CHECK(std::abs(status.sidesMetres[1] - 0.03) < 1e-6);
    CHECK(status.massKg == products.back().object->mass.massKg);
    CHECK_THAT(status.notes, ContainsSubstring("Scaled to a longest side of 50 mm."));
    workshop.analyseAgain({.longestMetres = 21});
    CHECK(productsOf(workshop).empty());
    CHECK(workshop.status().error == "plate.obj: The longest side must be between 1 mm and 20 m.");
}

TEST_CASE("A glTF file with a modal model is an object and is not analysed") {
    const auto bytes = encodeGlb(syntheticObject({300, 700}));
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    ObjectWorkshop workshop;
    workshop.open(writtenFile("synthetic.glb", std::string(text)), {});
    const auto products = productsOf(workshop);
    CHECK(workshop.status().error.empty());
    REQUIRE(products.size() == 1);
    CHECK(products.front().object->eigenvalues == syntheticObject({300, 700}).eigenvalues);
    CHECK(products.front().object->method == "synthetic");
}

TEST_CASE("A glTF mesh is in metres until another unit is chosen") {
    const auto mesh = sheetMesh(0.06, 0.036, 150);
    ObjectWorkshop workshop;
    workshop.open(writtenFile("plate.glb", glbOf(mesh)), {});
    CHECK_FALSE(productsOf(workshop).empty());
    CHECK(workshop.status().unit == "m");
    CHECK_THAT(workshop.status().notes,
               ContainsSubstring("The mesh measures 0.06 x 0.036 x 0 metres."));
    auto large = mesh;
    large.vertices *= 1000;
    CHECK(unitOf(large, UnitSource::format, {}).unit.symbol == "m");
    CHECK(unitOf(large, UnitSource::unknown, {}).unit.symbol == "mm");
    CHECK(unitOf(large, UnitSource::format, {.unit = "cm"}).unit.symbol == "cm");
    CHECK(unitOf(large, UnitSource::object, {.unit = "cm"}).unit.symbol == "m");
}

TEST_CASE("Impossible settings are refused in a sentence, and other settings can use the mesh") {
    ObjectWorkshop workshop;
    workshop.open(smallPlateFile("plate.obj", 1), {.thicknessMetres = -1});
    CHECK(productsOf(workshop).empty());
    CHECK_THAT(workshop.status().error, ContainsSubstring("thickness"));
    REQUIRE(workshop.hasMesh());
    for (const auto& settings :
         {ImportSettings{.unit = "furlong"}, ImportSettings{.material = "Unobtainium"},
          ImportSettings{.method = "guesswork"}}) {
        workshop.analyseAgain(settings);
        CHECK(productsOf(workshop).empty());
        CHECK(workshop.status().stage == ImportStage::failed);
        CHECK_THAT(workshop.status().error, ContainsSubstring("There is no"));
    }
    workshop.analyseAgain({.method = "fem"});
    CHECK(productsOf(workshop).empty());
    CHECK_THAT(workshop.status().error, ContainsSubstring("cannot be taken as a solid"));
}

TEST_CASE("A second analysis works without the file, with its new unit, material and thickness") {
    const auto file = smallPlateFile("gone.obj", 1);
    ObjectWorkshop workshop;
    workshop.open(file, {});
    productsOf(workshop);
    std::filesystem::remove(file);
    workshop.analyseAgain({.unit = "ft", .material = "glass", .thicknessMetres = 0.0004});
    const auto products = productsOf(workshop);
    REQUIRE(workshop.status().stage == ImportStage::done);
    REQUIRE_FALSE(products.empty());
    CHECK_FALSE(products.back().isNewFile);
    const auto& object = *products.back().object;
    CHECK(object.material.name == "Glass");
    CHECK(object.thicknessMetres == 0.0004);
    CHECK(*std::ranges::max_element(object.vertices) < 0.0095f);
}

TEST_CASE("A modal object is opened unchanged") {
    const auto file = testFolder() / "bell.modal";
    const auto object = syntheticObject({400, 900, 1700});
    REQUIRE(writeModalObject(object, file));
    ObjectWorkshop workshop;
    workshop.open(file, {});
    const auto products = productsOf(workshop);
    REQUIRE(products.size() == 1);
    CHECK_FALSE(products[0].isPreview);
    CHECK(products[0].object->eigenvalues == object.eigenvalues);
    CHECK(products[0].object->shapes == object.shapes);
    CHECK_FALSE(workshop.hasMesh());
}

TEST_CASE("A job cancelled at once makes nothing, and the next job works") {
    ObjectWorkshop workshop;
    const auto file = smallPlateFile("plate.obj", 1);
    for (int i = 0; i < 20; ++i) {
        workshop.open(file, {});
        workshop.cancel();
        CHECK(workshop.status().stage == ImportStage::cancelled);
        CHECK_FALSE(workshop.takeProduct());
    }
    workshop.open(file, {});
    CHECK_FALSE(productsOf(workshop).empty());
    CHECK(workshop.status().stage == ImportStage::done);
    workshop.cancel();
    CHECK(workshop.status().stage == ImportStage::done);
}

TEST_CASE("A cancellation discards a finished product that was not fetched") {
    ObjectWorkshop workshop;
    workshop.open(smallPlateFile("plate.obj", 1), {});
    waitUntil([&] { return !workshop.status().isWorking(); });
    REQUIRE(workshop.status().stage == ImportStage::done);
    workshop.cancel();
    CHECK(workshop.status().stage == ImportStage::done);
    CHECK_FALSE(workshop.takeProduct());
}

TEST_CASE("If a second job follows quickly, only its products arrive") {
    const auto first = smallPlateFile("first.obj", 1), second = smallPlateFile("second.obj", 1);
    for (const double progress : {0.0, 0.1, 0.5, 1.0}) {
        ObjectWorkshop workshop;
        workshop.open(first, {});
        waitForProgress(workshop, progress);
        workshop.takeProduct();
        workshop.open(second, {});
        const auto products = productsOf(workshop);
        REQUIRE_FALSE(products.empty());
        CHECK(products.front().isFirst);
        for (const auto& product : products)
            CHECK(product.object->name == "second");
        CHECK(workshop.status().stage == ImportStage::done);
    }
}

TEST_CASE("A workshop can be destroyed at any stage of its work") {
    const auto file = meshFile("ball.obj", icosphereMesh(0.1, 4));
    for (const double progress : {0.0, 0.01, 0.03, 0.1}) { // 0.1 is in the preview
        ObjectWorkshop workshop;
        workshop.open(file, {});
        waitForProgress(workshop, progress);
    }
    SUCCEED();
}
