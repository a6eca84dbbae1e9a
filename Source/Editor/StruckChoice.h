// The field of what was struck in a recording: the object that plays, a mesh file, a simple shape
// with its sizes, or unknown.
#pragma once

#include "Editor/FileButton.h"
#include "Editor/LengthField.h"
#include "Editor/Look.h"
#include "Editor/ProcessorView.h"
#include "Editor/Utf8.h"

#include <array>
#include <functional>
#include <string>
#include <utility>

namespace idiophone {

/// A size of a shape, which the user measures.
struct StruckSize {
    const char* name = nullptr;  ///< null: there is none
    const char* title = nullptr; ///< for the screen reader and the mouse
    double ShapeSizes::*size = nullptr;
    double perSize = 1; ///< 2 for the diameter of a radius
    double first = 0;   ///< in metres
};
/// The kinds of objects that can be struck.
struct StruckKind {
    const char* text;
    RecordedStrike::Struck struck;
    const char* shape = "";
    std::array<StruckSize, 4> fields = {};
};

inline constexpr StruckSize struckWall{"Thickness", "Thickness of its wall",
                                       &ShapeSizes::thicknessMetres, 1, 0.003};
inline constexpr std::array struckKinds{
    StruckKind{"The object that is shown", RecordedStrike::Struck::shown},
    StruckKind{"The object of a mesh file", RecordedStrike::Struck::mesh, "", {struckWall}},
    StruckKind{
        "A bar",
        RecordedStrike::Struck::shape,
        "box",
        {StruckSize{"Length", "Length of the bar", &ShapeSizes::lengthMetres, 1, 0.25},
         StruckSize{"Width", "Width of the bar", &ShapeSizes::widthMetres, 1, 0.04},
         StruckSize{"Thickness", "Thickness of the bar", &ShapeSizes::heightMetres, 1, 0.01}}},
    StruckKind{"A plate",
               RecordedStrike::Struck::shape,
               "plate",
               {StruckSize{"Length", "Length of the plate", &ShapeSizes::lengthMetres, 1, 0.3},
                StruckSize{"Width", "Width of the plate", &ShapeSizes::widthMetres, 1, 0.2},
                struckWall}},
    StruckKind{"A disc",
               RecordedStrike::Struck::shape,
               "disc",
               {StruckSize{"Diameter", "Diameter of the disc", &ShapeSizes::radiusMetres, 2, 0.2},
                struckWall}},
    StruckKind{
        "A ring of round rod",
        RecordedStrike::Struck::shape,
        "ring",
        {StruckSize{"Diameter", "Diameter of the ring, from the middle of the rod to the middle",
                    &ShapeSizes::radiusMetres, 2, 0.2},
         StruckSize{"Rod", "Thickness of the ring's rod", &ShapeSizes::sectionRadiusMetres, 2,
                    0.01}}},
    StruckKind{
        "A bowl, cup or pan",
        RecordedStrike::Struck::shape,
        "bowl",
        {StruckSize{"Rim", "Outer diameter of the rim", &ShapeSizes::radiusMetres, 2, 0.15},
         StruckSize{"Foot", "Diameter of the flat foot", &ShapeSizes::footRadiusMetres, 2, 0.07},
         StruckSize{"Height", "Height from foot to rim", &ShapeSizes::heightMetres, 1, 0.07},
         struckWall}},
    StruckKind{"Unknown: only the damping", RecordedStrike::Struck::unknown}};

/// Needs 280 x 74 pixels.
class StruckChoice final : public juce::Component {
    using Struck = RecordedStrike::Struck;

public:
    static constexpr int height = 74;

    explicit StruckChoice(MaterialFitView& materialFits)
        : view(materialFits), mesh("Mesh file...",
                                   "Mesh of the object",
                                   "Open the mesh of what was struck (OBJ, PLY, STL, OFF, glTF)",
                                   fromUtf8(materialFits.meshPatterns()),
                                   [this](const std::filesystem::path& file) { choose(file); }) {
        list.setTitle("What was struck");
        list.setTooltip("The pitches of a known object say how stiff the material is");
        list.onChange = [this] {
            isByHand = true;
            showChoice();
        };
        words.setTitle("About what was struck");
        words.setMinimumHorizontalScale(0.8f);
        addAndMakeVisible(list);
        addChildComponent(words);
        addChildComponent(mesh);
        for (auto& size : sizes)
            addChildComponent(size);
        refresh();
    }

    /// Called when the choice has changed.
    std::function<void()> onChange;

    /// Offers the object that plays now, if there is one, and takes it unless the user has chosen.
    void refresh() {
        const auto now = view.shownObject();
        if (now == object && list.getNumItems() > 0)
            return;
        object = now;
        const int before = list.getSelectedId();
        list.clear(juce::dontSendNotification);
        for (std::size_t i = 0; i < struckKinds.size(); ++i)
            if (struckKinds[i].struck != Struck::shown || !object.empty())
                list.addItem(struckKinds[i].text, static_cast<int>(i) + 1);
        isByHand = isByHand && list.indexOfItemId(before) >= 0;
        list.setSelectedId(isByHand ? before : list.getItemId(0), juce::dontSendNotification);
        showChoice();
    }

    /// Returns whether the choice has all that it needs.
    bool isComplete() const { return chosen().struck != Struck::mesh || !meshFile.empty(); }

    /// Adds to a strike what was struck.
    void describe(RecordedStrike& strike) const {
        const auto& choice = chosen();
        strike.struck = choice.struck;
        strike.mesh = meshFile;
        strike.shape = choice.shape;
        for (std::size_t i = 0; i < choice.fields.size(); ++i)
            if (const auto& field = choice.fields[i]; field.name != nullptr)
                strike.sizes.*field.size = sizes[i].metres() / field.perSize;
    }

    void resized() override {
        constexpr int gap = 8, line = 26;
        auto area = getLocalBounds();
        list.setBounds(area.removeFromTop(line));
        area.removeFromTop(5);
        words.setBounds(area);
        const int width = (area.getWidth() - 3 * gap) / 4;
        for (auto& size : sizes) {
            size.setBounds(area.removeFromLeft(width));
            area.removeFromLeft(gap);
        }
        mesh.setBounds(sizes[1].getBounds().getUnion(sizes[3].getBounds()).removeFromBottom(line));
    }
    void lookAndFeelChanged() override {
        words.setColour(juce::Label::textColourId, colourOf(*this, LookColour::dimText));
    }

private:
    const StruckKind& chosen() const {
        return struckKinds[static_cast<std::size_t>(std::max(list.getSelectedId(), 1)) - 1];
    }
    void choose(const std::filesystem::path& file) {
        meshFile = file;
        mesh.setButtonText(textOf(file.filename()));
        juce::NullCheckedInvocation::invoke(onChange);
    }
    void showChoice() {
        const auto& choice = chosen();
        const bool isNew = std::exchange(shown, &choice) != &choice;
        for (std::size_t i = 0; i < sizes.size(); ++i) {
            const auto& field = choice.fields[i];
            sizes[i].setVisible(field.name != nullptr);
            if (field.name != nullptr && isNew) // else it keeps what was typed
                sizes[i].show(field.name, field.title, field.first);
        }
        mesh.setVisible(choice.struck == Struck::mesh);
        words.setVisible(choice.struck == Struck::shown || choice.struck == Struck::unknown);
        words.setText(choice.struck == Struck::shown
                          ? fromUtf8(object)
                          : "Stiffness and density are then those of the material of the list that "
                            "it resembles most.",
                      juce::dontSendNotification);
        juce::NullCheckedInvocation::invoke(onChange);
    }

    MaterialFitView& view;
    std::string object; ///< MaterialFitView::shownObject
    const StruckKind* shown = nullptr;
    bool isByHand = false; ///< whether the user made the choice
    std::filesystem::path meshFile;
    juce::ComboBox list;
    TextLabel words;
    FileButton mesh;
    std::array<LengthField, 4> sizes;
};

} // namespace idiophone
