// Tests of the user's materials in the window: list, choice, name and errors.
#include "Editor/ChoiceList.h"
#include "Object/MaterialFile.h"
#include "Support/TestSound.h"
#include "Support/UserSettings.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <juce_gui_basics/juce_gui_basics.h>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Approx;
using Catch::Matchers::ContainsSubstring;

namespace {

const char* const jade = R"({"name": "Jade", "youngs_modulus_pa": 1.1e11, "poisson_ratio": 0.27,
    "density_kg_per_m3": 3300, "fluid_damping_per_s": 3, "viscoelastic_damping_s": 2e-8,
    "loss_factor": 1e-4})";

class UserFolder : public UserSettings {
public:
    void write(const std::string& name, const std::string& text) {
        UserSettings::write(userMaterialFolder().filename() / name, text);
    }
};

juce::ComboBox* materialList(juce::Component& component) {
    if (auto* list = dynamic_cast<juce::ComboBox*>(&component);
        list != nullptr && list->getTitle() == "Material")
        return list;
    for (auto* child : component.getChildren())
        if (auto* found = materialList(*child))
            return found;
    return nullptr;
}

} // namespace

TEST_CASE("The user's materials are listed by name after the built-in ones") {
    UserFolder folder;
    folder.write("z.json", jade);
    folder.write("Amber.json", R"({"youngs_modulus_pa": 3e9, "density_kg_per_m3": 1080,
                                   "poisson_ratio": 0.3, "loss_factor": 0.02})");
    Processor processor;
    const std::unique_ptr<juce::AudioProcessorEditor> window(processor.createEditor());
    auto* list = materialList(*window);
    REQUIRE(list != nullptr);
    const auto builtIn = choiceNames(ParameterId::material);
    const int count = static_cast<int>(builtIn.size());
    REQUIRE(list->getNumItems() == count + 2);
    CHECK(list->getItemText(count - 1).toStdString() == builtIn.back());
    CHECK(list->getItemText(count) == "Amber");
    CHECK(list->getItemText(count + 1) == "Jade");
}

TEST_CASE("A chosen user material sets the custom material's figures and shows its own name") {
    UserFolder folder;
    folder.write("jade.json", jade);
    Processor processor;
    const std::unique_ptr<juce::AudioProcessorEditor> window(processor.createEditor());
    auto* list = materialList(*window);
    list->setSelectedItemIndex(list->getNumItems() - 1, juce::sendNotificationSync);
    using enum ParameterId;
    CHECK(processor.view().parameters.value(material) == double{customMaterial});
    CHECK(processor.view().parameters.value(youngsModulus) == Approx(110));
    CHECK(processor.view().parameters.value(density) == 3300);
    CHECK(processor.view().parameters.value(fluidDamping) == 3);
    CHECK(processor.view().parameters.value(viscoelasticDamping) == Approx(0.02));
    CHECK(processor.view().parameters.value(lossFactor) == 1e-4);
    CHECK(processor.view().materials.userMaterialIndex() == 0);
    CHECK(list->getText() == "Jade");

    // The project stores the figures, so the file is no longer needed.
    const auto project = saved(processor);
    Processor reopened;
    restoreBytes(reopened, project);
    CHECK(reopened.view().parameters.value(lossFactor) == 1e-4);
    reopened.view().materials.readUserMaterials();
    CHECK(reopened.view().materials.userMaterialIndex() == 0);

    processor.view().parameters.change(density, 3301);
    CHECK(processor.view().materials.userMaterialIndex() == -1);
    processor.view().materials.chooseUserMaterial(1);
    processor.view().materials.chooseUserMaterial(-1);
    CHECK(processor.view().parameters.value(density) == 3301);
}

TEST_CASE("A closed list of materials shows changes that another list has read") {
    UserFolder folder;
    folder.write("jade.json", jade);
    Processor processor;
    const std::unique_ptr<juce::AudioProcessorEditor> window(processor.createEditor());
    auto* list = dynamic_cast<ChoiceList*>(materialList(*window));
    REQUIRE(list != nullptr);
    list->setSelectedItemIndex(list->getNumItems() - 1, juce::sendNotificationSync);
    const int count = list->getNumItems();
    folder.write("Amber.json", R"({"youngs_modulus_pa": 3e9, "density_kg_per_m3": 1080,
                                   "poisson_ratio": 0.3, "loss_factor": 0.02})");
    processor.view().materials.readUserMaterials();
    list->refresh();
    CHECK(list->getNumItems() == count + 1);
    CHECK(list->getText() == "Jade");
}

TEST_CASE("The status reports an invalid material file, and other materials remain") {
    UserFolder folder;
    folder.write("jade.json", jade);
    folder.write("broken.json", R"({"name": "Broken"})");
    Processor processor;
    const auto before = saved(processor);
    CHECK(processor.view().materials.readUserMaterials() == std::vector<std::string>{"Jade"});
    const auto status = processor.view().status.takeStatus();
    CHECK(status.isError);
    CHECK_THAT(status.sentence, ContainsSubstring("broken.json"));
    CHECK_THAT(status.sentence, ContainsSubstring("'youngs_modulus_pa'"));
    CHECK(saved(processor) == before);
}
