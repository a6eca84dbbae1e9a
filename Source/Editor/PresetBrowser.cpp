#include "Editor/PresetBrowser.h"

#include "Editor/Look.h"
#include "Editor/PresetSearch.h"
#include "Editor/Utf8.h"

#include <map>

namespace idiophone {
namespace {

constexpr int padding = 10, gap = 8, rowHeight = 28;
constexpr int minimumSources = 130, maximumSources = 220;
constexpr int minimumListHeight = 60; ///< if less is left, the form hides the list

} // namespace

void PresetBrowser::Search::paintOverChildren(juce::Graphics& g) {
    constexpr int besideCaret = 4;
    TextEditor::paintOverChildren(g);
    if (!isEmpty() || !hasKeyboardFocus(false))
        return;
    g.setColour(colourOf(*this, LookColour::dimText));
    g.setFont(getFont());
    g.drawText(getTextToShowWhenEmpty(),
               getLocalBounds().withTrimmedLeft(getLeftIndent() + besideCaret),
               juce::Justification::centredLeft, true);
}

PresetBrowser::PresetBrowser(PresetShelf& presetShelf) : shelf(presetShelf) {
    setTitle("Preset browser");
    setFocusContainerType(FocusContainerType::keyboardFocusContainer);
    search.setTitle("Search presets");
    search.setTextToShowWhenEmpty("Search names, tags, descriptions, authors", {});
    search.setFont(Look::textFont(14.5f));
    search.setIndents(8, 0);
    search.setSelectAllWhenFocused(true); // new words replace the previous search
    search.setJustification(juce::Justification::centredLeft);
    search.onTextChange = [this] { refill(); };
    search.onReturnKey = [this] { close(true); };
    search.onEscapeKey = [this] { close(false); };
    sources.onChange = [this] { refill(); };
    list.onSelect = [this](const ShelvedPreset& preset) { audition(preset); };
    list.onChoose = [this] { close(true); };
    list.onStar = [this](const ShelvedPreset& preset) {
        const auto id = preset.id;
        const auto starred = shelf.setFavourite(id, !preset.isFavourite);
        refill();
        if (!starred)
            say(fromUtf8(starred.error().message), true);
    };
    form.onCancel = [this] { ask(Question::none); };
    form.onAnswer = [this](const PresetDetails& details) { answer(details); };
    showActions();
    playSwitch.setTitle(playSwitch.getButtonText());
    playSwitch.setTooltip("Selecting a preset plays a short phrase");
    playSwitch.onClick = [this] {
        juce::NullCheckedInvocation::invoke(onPlaySwitch, playSwitch.getToggleState());
    };
    showParts(*this, search, clear, playSwitch, sources, list, saveAs, rename, remove, reveal, init,
              status, back, keep);
    addChildComponent(form);
}

void PresetBrowser::showActions() {
    const auto action = [](juce::TextButton& button, const char* tooltip, auto&& clicked) {
        button.setTitle(button.getButtonText());
        button.setTooltip(tooltip);
        button.onClick = clicked;
    };
    action(clear, "Show all presets: clear the search and the filters", [this] {
        clearFilters();
        search.grabKeyboardFocus();
    });
    action(saveAs, "Save the current sound as a new preset", [this] { ask(Question::save); });
    action(rename, "Give the selected preset another name", [this] { ask(Question::rename); });
    action(remove, "Move the selected preset to the bin", [this] { ask(Question::remove); });
    action(reveal, "Show the folder of your presets", [this] {
        const auto folder = shelf.presetFolder();
        if (folder)
            juce::File(fromUtf8(*folder)).revealToUser();
        else
            say(fromUtf8(folder.error().message), true);
    });
    action(init, "Start from a plain sound", [this] {
        shelf.keepAudition();
        const auto loaded = shelf.loadInitialSound();
        refill();
        say(loaded ? "A plain sound plays." : fromUtf8(loaded.error().message), !loaded);
    });
    action(back, "Restore the previous sound (Escape)", [this] { close(false); });
    action(keep, "Keep the current sound (Return)", [this] { close(true); });
    status.setTitle("Message");
    status.setFont(Look::textFont());
    status.setMinimumHorizontalScale(0.8f);
}

void PresetBrowser::open() {
    shelf.readPresets();
    ask(Question::none);
    say({}, false);
    refill();
    if (list.selected() == nullptr)
        clearFilters();
    search.grabKeyboardFocus();
}

void PresetBrowser::close(bool kept) {
    if (kept)
        shelf.keepAudition();
    else
        shelf.endAudition();
    juce::NullCheckedInvocation::invoke(onClose);
}

void PresetBrowser::clearFilters() {
    search.clear();
    sources.chooseAll();
    refill();
}

/// Lists the presets that pass, those without typing errors first.
void PresetBrowser::refill() {
    sources.show(shelf.presets());
    std::map<int, std::vector<ShelvedPreset>> found; // by errors
    for (const auto& preset : shelf.presets())
        if (sources.passes(preset))
            if (const auto errors = searchErrors(preset, search.getText()))
                found[*errors].push_back(preset);
    std::vector<ShelvedPreset> passing;
    for (const auto& [errors, presets] : found)
        passing.insert(passing.end(), presets.begin(), presets.end());
    list.show(std::move(passing), shelf.playingPreset().id);
    if (found.empty())
        say("No preset has all of these words and tags.", false);
    else if (!found.contains(0))
        say("No preset has exactly these words; these are similar.", false);
    else if (saysSearch)
        say({}, false);
    saysSearch = !found.contains(0);
    clear.setVisible(!search.isEmpty() || sources.isNarrowed());
    resized();
    arrangeHint();
}

void PresetBrowser::audition(const ShelvedPreset& preset) {
    if (question == Question::rename || question == Question::remove)
        ask(Question::none); // the form was about another preset
    const auto played = shelf.auditionPreset(preset.id);
    say(played ? juce::String() : fromUtf8(played.error().message), !played);
    arrangeHint();
    if (played)
        juce::NullCheckedInvocation::invoke(onSelect);
}

void PresetBrowser::arrangeHint() {
    const auto* preset = list.selected();
    const bool isOwn = preset != nullptr && !preset->isFactory;
    rename.setEnabled(isOwn && preset->fault.empty());
    remove.setEnabled(isOwn);
}

void PresetBrowser::say(const juce::String& sentence, bool isError) {
    saysError = isError;
    saysSearch = false;
    colourStatus();
    status.setText(sentence, juce::dontSendNotification);
    status.setTooltip(sentence);
}

void PresetBrowser::colourStatus() {
    status.setColour(juce::Label::textColourId,
                     colourOf(*this, saysError ? LookColour::error : LookColour::dimText));
}

void PresetBrowser::ask(Question next) {
    question = next;
    const auto* preset = list.selected();
    askedId = preset != nullptr ? preset->id : std::string();
    if (question == Question::save) {
        auto details = shelf.playingPreset().details;
        if (preset != nullptr && preset->isFactory)
            details.author.clear(); // another user is the author of the copy
        form.askForDetails(details);
    } else if (question == Question::rename && preset != nullptr) {
        form.askForName("Rename " + fromUtf8(preset->name), preset->name);
    } else if (question == Question::remove && preset != nullptr) {
        form.askWhether("Move '" + fromUtf8(preset->name) + "' to the bin?", "Delete");
    } else {
        question = Question::none;
    }
    form.setVisible(question != Question::none);
    resized();
    if (question != Question::none)
        form.takeFocus();
    else if (isShowing())
        search.grabKeyboardFocus();
}

void PresetBrowser::answer(const PresetDetails& details) {
    const bool mayReplace = question == Question::save && form.isToReplace();
    if (question == Question::save && !mayReplace && shelf.presetExists(details))
        return form.objectToName(details);
    if (question == Question::save)
        shelf.keepAudition(); // saving also keeps the sound
    const auto done = question == Question::save     ? shelf.savePreset(details, mayReplace)
                      : question == Question::rename ? shelf.renamePreset(askedId, details.name)
                                                     : shelf.deletePreset(askedId);
    if (!done)
        return form.object(fromUtf8(done.error().message));
    const auto said = question == Question::save     ? "Saved."
                      : question == Question::rename ? "Renamed."
                                                     : "In the bin.";
    ask(Question::none);
    refill();
    say(said, false);
}

bool PresetBrowser::movesInList(const juce::KeyPress& key) {
    using juce::KeyPress;
    return key == KeyPress::downKey || key == KeyPress::upKey || key == KeyPress::pageDownKey ||
           key == KeyPress::pageUpKey;
}

bool PresetBrowser::keyPressed(const juce::KeyPress& key) {
    if (key == juce::KeyPress::escapeKey)
        close(false);
    else if (key == juce::KeyPress::returnKey)
        close(true);
    else if (key == juce::KeyPress::downKey)
        list.step(1);
    else if (key == juce::KeyPress::upKey)
        list.step(-1);
    else if (key == juce::KeyPress::pageDownKey)
        list.step(6);
    else if (key == juce::KeyPress::pageUpKey)
        list.step(-6);
    else if (question != Question::none &&
             key == juce::KeyPress('s', juce::ModifierKeys::commandModifier, 0))
        form.save(); // otherwise the shortcut would overwrite the current preset
    else
        return false;
    return true;
}

void PresetBrowser::paint(juce::Graphics& g) {
    g.setColour(colourOf(*this, LookColour::panel));
    g.fillRoundedRectangle(getLocalBounds().toFloat(), 6);
    g.setColour(colourOf(*this, LookColour::background));
    if (list.isVisible())
        g.fillRoundedRectangle(list.getBounds().toFloat(), 5);
}

void PresetBrowser::resized() {
    auto area = getLocalBounds().reduced(padding);
    auto actions = area.removeFromBottom(rowHeight);
    area.removeFromBottom(gap);
    keep.setBounds(actions.removeFromRight(72));
    actions.removeFromRight(4);
    back.setBounds(actions.removeFromRight(72));
    actions.removeFromRight(gap);
    for (auto* button : {&saveAs, &rename, &remove, &reveal, &init}) {
        button->setBounds(actions.removeFromLeft(button == &saveAs ? 84 : 66));
        actions.removeFromLeft(4);
    }
    status.setBounds(actions);

    sources.setBounds(
        area.removeFromLeft(juce::jlimit(minimumSources, maximumSources, area.getWidth() / 5)));
    area.removeFromLeft(gap);
    auto top = area.removeFromTop(rowHeight);
    playSwitch.setBounds(top.removeFromRight(144));
    top.removeFromRight(gap);
    if (clear.isVisible()) {
        clear.setBounds(top.removeFromRight(58));
        top.removeFromRight(gap);
    }
    search.setBounds(top);
    area.removeFromTop(gap);
    if (form.isVisible()) {
        form.setBounds(area.removeFromBottom(juce::jmin(form.neededHeight(), area.getHeight())));
        area.removeFromBottom(gap);
    }
    list.setVisible(area.getHeight() >= minimumListHeight);
    list.setBounds(area);
}

} // namespace idiophone
