#include "Editor/EditorWindow.h"

#include "Editor/DroppedFiles.h"
#include "Editor/ImportPage.h"
#include "Editor/KitPage.h"
#include "Editor/MaterialPage.h"
#include "Editor/ModesPage.h"
#include "Editor/PlainPages.h"
#include "Editor/PlayPage.h"
#include "Editor/QualityPage.h"
#include "Editor/StrikePage.h"
#include "Editor/TuningPage.h"

#include <algorithm>
#include <vector>

namespace idiophone {
namespace {

constexpr int margin = 12, barHeight = 44, statusHeight = 38;
/// Height of picture and deck below which the picture stands beside the deck, not above it.
constexpr int minimumHeightForBoth = PageDeck::minimumHeight + 200;
constexpr double deckShare = 0.44;
/// Update rates in Hz: while something sounds or the mouse is over the window, and at rest. Rest
/// starts after `ticksToRest` quiet ticks.
constexpr int busyHz = 25, restHz = 8, ticksToRest = 50;

} // namespace

EditorWindow::EditorWindow(juce::AudioProcessor& audioProcessor, ProcessorView& processorView)
    : AudioProcessorEditor(audioProcessor), view(processorView), look(preferences.look()),
      presets(view), object(view), controllers(view), browser(view.presets), samples(view),
      recorder(view), volume(parameterInfo(ParameterId::volume), view), keyboard(view) {
    setLookAndFeel(&look);
    makePages();
    lookButton.onLook = [this](LookScheme scheme) { setLook(scheme); };
    recorder.onWidth = [this] { placeParts(); };
    silence.describe("Silence", "End all sound at once");
    silence.onClick = [this] {
        phrase.stop();
        view.instrument.silence();
    };
    scaleButton.onScale = [this](int percent) {
        preferences.setScalePercent(percent);
        setScale(percent);
    };
    showParts(*this, presets, scaleButton, lookButton, object, deck, status, recorder, silence,
              volume, keyboard);
    addChildComponent(controllers);
    addChildComponent(browser);
    addChildComponent(samples);
    deck.setShowsUnits(preferences.showsUnits());
    deck.onUnits = [this] { preferences.setShowsUnits(deck.showsUnits()); };
    controllers.onClose = [this] { show(Middle::pages); };
    presets.onBrowse = [this] { setBrowsing(!browser.isVisible()); };
    presets.onSaveAs = [this] {
        setBrowsing(true);
        browser.askToSave();
    };
    browser.onClose = [this] { setBrowsing(false); };
    samples.onClose = [this] { show(Middle::pages); };
    recorder.onSamples = [this] { show(samples.isVisible() ? Middle::pages : Middle::samples); };
    playPhrases();
    object.picture().addChildComponent(firstHints);
    addChildComponent(dropFrame);
    addChildComponent(focusRing);
    setLook(look.scheme());
    setConstrainer(&limits);
    setResizable(true, true);
    const auto size = preferences.windowSize();
    setSize(size.x, size.y);
    setScale(ScaleButton::fitting(preferences.scalePercent(), WindowSize::screen()));
    startTimer(1000 / busyHz);
}

EditorWindow::~EditorWindow() {
    view.presets.keepAudition();
    object.removeMouseListener(&phrase);
    keyboard.removeMouseListener(&phrase);
    preferences.setWindowSize({getWidth(), getHeight()});
    setLookAndFeel(nullptr);
    view.parameters.endAllChanges();
}

void EditorWindow::makePages() {
    deck.add(std::make_unique<PlayPage>(view));
    deck.add(std::make_unique<StrikePage>(view));
    deck.add(std::make_unique<MaterialPage>(view));
    auto modes = std::make_unique<ModesPage>(view);
    modes->onModeShown = [this](std::optional<std::size_t> mode) {
        object.picture().showMode(mode);
    };
    deck.add(std::move(modes));
    tuningPage = deck.pageCount();
    deck.add(std::make_unique<TuningPage>(view));
    addPlainPages(deck, view);
    importPage = deck.pageCount();
    deck.add(std::make_unique<ImportPage>(view));
    kitPage = deck.pageCount();
    auto kit = std::make_unique<KitPage>(view);
    kit->onKeysShown = [this](const auto& keys) { keyboard.mark(keys); };
    keyboard.onKey = [page = kit.get()](int note) { page->chooseKey(note); };
    deck.add(std::move(kit));
    deck.add(std::make_unique<QualityPage>(view));
}

/// A selected preset plays a phrase until something is struck by hand.
void EditorWindow::playPhrases() {
    browser.setPlaysOnSelection(preferences.playsOnSelection());
    browser.onPlaySwitch = [this](bool plays) {
        preferences.setPlaysOnSelection(plays);
        phrase.stop();
    };
    presets.onStep = browser.onSelect = [this] {
        if (preferences.playsOnSelection())
            phrase.play();
    };
    object.addMouseListener(&phrase, true);
    keyboard.addMouseListener(&phrase, true);
}

void EditorWindow::setLook(LookScheme scheme) {
    look.setScheme(scheme);
    preferences.setLook(scheme);
    lookButton.show(scheme);
    sendLookAndFeelChange();
    dialogs->setScheme(scheme);
    colourSurroundings();
    recolourTexts(*this);
    repaint();
}

/// Colours the standalone's window, which JUCE makes before this one.
void EditorWindow::colourSurroundings() {
    if (auto* around = dynamic_cast<juce::ResizableWindow*>(getTopLevelComponent()))
        around->setBackgroundColour(colourOf(look.scheme(), LookColour::background));
}

void EditorWindow::setScale(int percent) {
    scaleButton.show(percent);
    userScale = float(percent) / 100;
    const bool isStandalone = juce::JUCEApplicationBase::isStandaloneApp();
    const auto screen = isStandalone ? WindowSize::framedScreen(userScale) : WindowSize::screen();
    const auto size = WindowSize::within(screen, {getWidth(), getHeight()}, userScale * hostScale);
    if (isStandalone) // its frame, menus and dialogs grow too
        juce::Desktop::getInstance().setGlobalScaleFactor(userScale);
    setSize(size.x, size.y);
    setScaleFactor(hostScale);
    if (isStandalone && getTopLevelComponent() != this)
        WindowSize::keepOnScreen(*getTopLevelComponent());
}

void EditorWindow::setScaleFactor(float ofHost) {
    hostScale = ofHost;
    const float own = juce::JUCEApplicationBase::isStandaloneApp() ? 1 : userScale;
    limits.setScale(hostScale * own);
    AudioProcessorEditor::setScaleFactor(hostScale * own);
}

void EditorWindow::show(Middle shown) {
    if (shown != Middle::browser)
        view.presets.keepAudition();
    browser.setVisible(shown == Middle::browser);
    samples.setVisible(shown == Middle::samples);
    object.setVisible(shown == Middle::pages || shown == Middle::controllers);
    deck.setVisible(shown == Middle::pages);
    controllers.setVisible(shown == Middle::controllers);
    if (shown == Middle::browser)
        browser.open();
    else if (shown == Middle::samples)
        samples.open();
    else if (shown == Middle::pages && isShowing() && juce::JUCEApplicationBase::isStandaloneApp())
        keyboard.takeFocus();
    presets.refresh();
}

bool EditorWindow::keyPressed(const juce::KeyPress& key) {
    if (key.isKeyCode(juce::KeyPress::tabKey))
        focusRing.tabPressed();
    return presets.handleKey(key) || (controllers.isVisible() && controllers.keyPressed(key)) ||
           (samples.isVisible() && samples.keyPressed(key)) ||
           (juce::JUCEApplicationBase::isStandaloneApp() && keyboard.pressOctaveKey(key)) ||
           AudioProcessorEditor::keyPressed(key);
}

// In the standalone program the computer's keys play notes, unless the focused component wants
// them. In a plugin the keys belong to the host.
bool EditorWindow::keyStateChanged(bool isDown) {
    if (!juce::JUCEApplicationBase::isStandaloneApp())
        return false;
    if (dynamic_cast<juce::TextInputTarget*>(getCurrentlyFocusedComponent()) != nullptr)
        return false; // a text field takes key presses, but passes key releases on
    return keyboard.followKeys(isDown);
}

void EditorWindow::focusOfChildComponentChanged(FocusChangeType) {
    if (!hasKeyboardFocus(true) ||
        dynamic_cast<juce::TextInputTarget*>(getCurrentlyFocusedComponent()) != nullptr)
        keyboard.releaseKeys();
}

void EditorWindow::timerCallback() {
    presets.refresh();
    object.refresh();
    deck.refresh();
    recorder.refresh();
    if (samples.isVisible())
        samples.refresh();
    controllers.refresh();
    volume.refresh();
    keyboard.refresh();
    const auto now = view.status.takeStatus();
    setBusy(now.peak > 0 || isMouseOver(true));
    status.show(now);
    status.showHint(
        hint.find(*this, juce::Desktop::getInstance().getMainMouseSource().getComponentUnderMouse(),
                  focusRing.component()));
    if (isShowing() && !preferences.areHintsSeen()) {
        preferences.setHintsSeen();
        firstHints.start();
    }
    if (const auto* frame = view.sound.takeSoundFrame()) {
        object.picture().showSound(*frame);
        deck.showSound(*frame);
    }
    // If the surrounding window has the focus, its key presses do not arrive here.
    if (juce::JUCEApplicationBase::isStandaloneApp() &&
        getCurrentlyFocusedComponent() == getTopLevelComponent())
        keyboard.takeFocus();
}

void EditorWindow::setBusy(bool busy) {
    ticksAtRest = busy ? 0 : std::min(ticksAtRest + 1, ticksToRest);
    const int hertz = ticksAtRest < ticksToRest ? busyHz : restHz;
    if (getTimerInterval() != 1000 / hertz)
        startTimer(1000 / hertz);
}

bool EditorWindow::isInterestedInFileDrag(const juce::StringArray& files) {
    // Accept unreadable files too, to report the reason. Ignore a capture dropped back on the
    // window.
    return !files.isEmpty() && !DragFolder::contains(pathOf(files[0]));
}

void EditorWindow::fileDragMove(const juce::StringArray& files, int x, int y) {
    const DroppedFiles dropped(files, view, noteAt(x, y));
    dropFrame.show(dropped.offer(), dropped.kind() != DroppedFiles::Kind::unreadable);
}

void EditorWindow::fileDragExit(const juce::StringArray&) {
    dropFrame.hide();
}

void EditorWindow::filesDropped(const juce::StringArray& files, int x, int y) {
    dropFrame.hide();
    const DroppedFiles dropped(files, view, noteAt(x, y));
    dropped.open();
    if (dropped.kind() == DroppedFiles::Kind::tuning)
        showPage(tuningPage);
    else if (dropped.kind() == DroppedFiles::Kind::object)
        showPage(noteAt(x, y) ? kitPage : importPage);
}

void EditorWindow::resized() {
    placeParts();
    controllers.setBounds(deck.getBounds());
    focusRing.follow();
}

void EditorWindow::placeParts() {
    dropFrame.setBounds(getLocalBounds());
    auto area = getLocalBounds().reduced(margin, 0);
    auto bar = area.removeFromTop(barHeight);
    lookButton.setBounds(bar.removeFromRight(34).reduced(0, 8));
    scaleButton.setBounds(bar.removeFromRight(ScaleButton::width).reduced(4, 8));
    presets.setBounds(bar.withTrimmedRight(8));
    area.removeFromBottom(8);
    keyboard.setBounds(area.removeFromBottom(std::clamp(getHeight() / 8, 60, 140)));
    auto line = area.removeFromBottom(statusHeight);
    volume.setBounds(line.removeFromRight(150));
    silence.setBounds(line.removeFromRight(36).withSizeKeepingCentre(28, 28));
    recorder.setBounds(line.removeFromRight(recorder.width()));
    status.setBounds(line.withTrimmedRight(4));
    browser.setBounds(area);
    samples.setBounds(area);
    if (area.getHeight() < minimumHeightForBoth) {
        const int fitting = (area.getWidth() * 3 / 5) / DeckPage::minimumWidth;
        const int pages = std::clamp(fitting, 1, deck.pageCount());
        deck.setBounds(area.removeFromRight(PageDeck::widthFor(pages)));
        object.setBounds(area.withTrimmedRight(PageDeck::gap));
        return;
    }
    const auto share = static_cast<int>(deckShare * area.getHeight());
    deck.setBounds(area.removeFromBottom(std::clamp(
        share, PageDeck::minimumHeight, PageDeck::aboveHeight + DeckPage::maximumHeight)));
    object.setBounds(area.withTrimmedBottom(4));
}

} // namespace idiophone
