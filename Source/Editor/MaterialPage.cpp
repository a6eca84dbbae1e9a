#include "Editor/MaterialPage.h"

#include <algorithm>

namespace idiophone {
namespace {

using enum ParameterId;

/// Changes less than this many timer ticks apart count as one change.
constexpr int settledTicks = 12;
constexpr int gap = 16, lowestRow = 34, highestRow = 50, lineHeight = 26;

} // namespace

MaterialPage::MaterialPage(ProcessorView& processor)
    : DeckPage("Material"), view(processor), pad(processor),
      list(parameterInfo(ParameterId::material), processor),
      match(parameterInfo(matchLoudness), processor), keep(parameterInfo(keepPitch), processor) {
    for (const std::string_view group : {"Material figures", "Extent"})
        for (const auto& info : parameterTable())
            if (info.group == group)
                figures.push_back(std::make_unique<ParameterControl>(info, processor));
    former.setTitle("Material before");
    former.setTooltip("Swap with the material before the last change");
    former.onClick = [this] { swapMaterials(); };
    addAndMakeVisible(list);
    addAndMakeVisible(pad);
    addAndMakeVisible(former);
    addAndMakeVisible(match);
    addAndMakeVisible(keep);
    for (auto& figure : figures)
        addAndMakeVisible(*figure);
    now = before = figuresNow();
}

MaterialPage::Figures MaterialPage::figuresNow() const {
    Figures result{};
    std::ranges::transform(parameters, result.begin(),
                           [&](ParameterId id) { return view.parameters.value(id); });
    return result;
}

void MaterialPage::watch() {
    const auto fresh = figuresNow();
    if (view.instrument.instrumentNumber() != instrument) {
        instrument = view.instrument.instrumentNumber();
        now = before = fresh;
    } else if (fresh != now) {
        if (ticksUnchanged >= settledTicks)
            before = now;
        now = fresh;
        ticksUnchanged = 0;
    } else {
        ticksUnchanged = std::min(ticksUnchanged + 1, settledTicks);
    }
    former.setEnabled(before != now);
}

void MaterialPage::swapMaterials() {
    watch();
    const auto wanted = before;
    before = now;
    now = wanted;
    for (const auto parameter : parameters)
        view.parameters.beginChange(parameter);
    // Set the choice last, after its figures.
    for (std::size_t i = 0; i < parameters.size(); ++i)
        view.parameters.change(parameters[i], wanted[i]);
    for (const auto parameter : parameters)
        view.parameters.endChange(parameter);
    ticksUnchanged = settledTicks;
    refresh();
}

void MaterialPage::refresh() {
    watch();
    pad.refresh();
    list.refresh();
    match.refresh();
    keep.refresh();
    for (auto& figure : figures)
        figure->refresh();
}

void MaterialPage::resized() {
    auto area = getLocalBounds().reduced(padding);
    auto left = area.removeFromLeft((area.getWidth() - gap) / 2);
    area.removeFromLeft(gap);
    auto top = left.removeFromTop(lineHeight);
    former.setBounds(top.removeFromRight(46).reduced(0, 1));
    list.setBounds(top.withTrimmedRight(6));
    match.setBounds(left.removeFromBottom(lineHeight));
    keep.setBounds(left.removeFromBottom(lineHeight));
    left.removeFromTop(6);
    pad.setBounds(left.withTrimmedBottom(4));
    const int row =
        std::clamp(area.getHeight() / static_cast<int>(figures.size()), lowestRow, highestRow);
    for (auto& figure : figures)
        figure->setBounds(area.removeFromTop(row));
}

} // namespace idiophone
