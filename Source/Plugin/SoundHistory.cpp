#include "Plugin/SoundHistory.h"

#include "Editor/Utf8.h"

#include <algorithm>
#include <limits>
#include <set>

namespace idiophone {
namespace {

// Limits of juce::UndoManager, in KiB. It always keeps the newest steps.
constexpr int mostUnits = 512 * 1024, fewestSteps = 8;
constexpr int unitsOfParameters = 64; // above the actual size, so that at most 8192 steps are kept
constexpr int unitsOfSound = 256;
constexpr int unitsOfTunings = 1024; // two tunings of two files each

int unitsOfObjects(const Sound& sound) {
    if (sound.instrument == nullptr)
        return 0;
    std::set<const ModalObject*> objects;
    for (const auto& slot : sound.instrument->slots())
        objects.insert(slot.object.get());
    std::size_t bytes = 0;
    for (const auto* object : objects)
        bytes += sizeof(float) * (object->shapes.size() + object->vertices.size() +
                                  object->radiation.weights.size());
    return static_cast<int>(std::min<std::size_t>(bytes / 1024, mostUnits));
}

} // namespace

/// A step that is done when it is made.
class SoundHistory::Step final : public juce::UndoableAction {
public:
    Step(std::function<bool()> undoIt, std::function<bool()> doItAgain, int size)
        : undone(std::move(undoIt)), doneAgain(std::move(doItAgain)), units(size) {}

    bool perform() override { return !std::exchange(isDone, true) || doneAgain(); }
    bool undo() override { return undone(); }
    int getSizeInUnits() override { return units; }

private:
    std::function<bool()> undone, doneAgain;
    int units;
    bool isDone = false;
};

SoundHistory::SoundHistory(SoundHolder& soundHolder,
                           HostParameters& hostParameters,
                           HostLoads& loadsOfHost)
    : holder(soundHolder), parameters(hostParameters), hostLoads(loadsOfHost),
      steps(mostUnits, fewestSteps) {}

SoundHistory::~SoundHistory() = default;

bool SoundHistory::canUndo() {
    followHost();
    return !changes.empty() || steps.canUndo();
}

bool SoundHistory::canRedo() {
    followHost();
    return changes.empty() && steps.canRedo();
}

std::string SoundHistory::undoName() {
    followHost();
    return steps.getUndoDescription().toStdString();
}

std::string SoundHistory::redoName() {
    followHost();
    return steps.getRedoDescription().toStdString();
}

void SoundHistory::undo() {
    endAudition();
    followHost();
    closeEdit();
    programs.reset();
    steps.undo();
}

void SoundHistory::redo() {
    endAudition();
    followHost();
    closeEdit();
    programs.reset();
    steps.redo();
}

void SoundHistory::record(const std::string& name, const std::function<void()>& load) {
    endAudition();
    followHost();
    closeEdit();
    const auto before = session();
    load();
    pushLoad(name, before);
}

void SoundHistory::recordDone(const std::string& name,
                              const std::function<void()>& undone,
                              const std::function<void()>& doneAgain) {
    endAudition();
    followHost();
    closeEdit();
    const auto always = [](const std::function<void()>& work) {
        return [work] {
            work();
            return true;
        };
    };
    push(new Step(always(undone), always(doneAgain), unitsOfTunings), name);
}

bool SoundHistory::playsB() {
    followHost();
    return other.playsB;
}

void SoundHistory::renewSounds(const std::function<void(Sound&)>& renew) {
    const auto renewIn = [&](Session& kept) {
        renew(kept.playing);
        if (kept.other.sound)
            renew(*kept.other.sound);
    };
    for (const auto& known : loads)
        if (const auto sessions = known.lock()) {
            renewIn(sessions->before);
            renewIn(sessions->after);
        }
    if (other.sound)
        renew(*other.sound);
    if (beforeAudition)
        renewIn(*beforeAudition);
}

bool SoundHistory::play(const Session& wanted) {
    if (holder.loadedSound() != wanted.playing && !holder.playSound(wanted.playing))
        return false;
    other = wanted.other;
    return true;
}

void SoundHistory::followHost() {
    if (hostLoads.counted() != knownHostLoads)
        forgetAll();
    if (auto before = hostLoads.takeBeforePrograms())
        recordPrograms(std::move(*before));
}

/// A program change ends an audition, as loading another sound does.
void SoundHistory::recordPrograms(Sound before) {
    if (beforeAudition)
        changes.clear();
    closeEdit(&before.parameters);
    const auto from = std::exchange(beforeAudition, std::nullopt)
                          .value_or(Session{.playing = std::move(before), .other = other});
    const auto name = holder.loadedLabel().name;
    if (const auto known = programs.lock()) {
        known->after = session();
        steps.setCurrentTransactionName(fromUtf8(name));
    } else if (pushLoad(name, from)) {
        programs = loads.back();
    }
}

void SoundHistory::forgetAll() {
    knownHostLoads = hostLoads.counted();
    steps.clearUndoHistory();
    programs.reset();
    other = {};
    beforeAudition.reset();
    changes.clear();
}

void SoundHistory::closeEdit(const ParameterValues* values) {
    auto done = std::exchange(changes, {});
    for (auto& change : done)
        change.after = values != nullptr ? (*values)[change.parameter]
                                         : parameters[change.parameter].exactValue();
    std::erase_if(done, [](const Change& change) { return change.after == change.before; });
    if (done.empty())
        return;
    const auto name = !editName.empty()  ? editName
                      : done.size() == 1 ? std::string(parameterInfo(done.front().parameter).name)
                                         : std::to_string(done.size()) + " parameters";
    const auto undo = [this, done] {
        for (auto change = done.rbegin(); change != done.rend(); ++change)
            parameters[change->parameter].changeByHand(change->before);
        return true;
    };
    const auto redo = [this, done] {
        for (const auto& change : done)
            parameters[change.parameter].changeByHand(change.after);
        return true;
    };
    push(new Step(undo, redo, unitsOfParameters), name);
}

void SoundHistory::push(Step* step, const std::string& name) {
    programs.reset();
    steps.beginNewTransaction(fromUtf8(name));
    steps.perform(step);
}

bool SoundHistory::pushLoad(const std::string& name, const Session& before) {
    auto after = session();
    if (after == before)
        return false;
    auto sessions = std::make_shared<LoadedSessions>(
        LoadedSessions{.before = before, .after = std::move(after)});
    std::erase_if(loads, [](const auto& known) { return known.expired(); });
    loads.push_back(sessions);
    auto units = unitsOfSound;
    if (before.playing.instrument != sessions->after.playing.instrument)
        units += unitsOfObjects(before.playing);
    push(new Step([this, sessions] { return play(sessions->before); },
                  [this, sessions] { return play(sessions->after); }, units),
         name);
    return true;
}

void SoundHistory::beginGesture(ParameterId parameter) {
    followHost();
    if (gestures.none() && openEdits == 0)
        closeEdit();
    gestures.set(static_cast<std::size_t>(parameter));
}

void SoundHistory::willChange(ParameterId parameter) {
    if (openEdits == 0 && !gestures.test(static_cast<std::size_t>(parameter)))
        return;
    followHost();
    const auto known =
        std::ranges::any_of(changes, [&](const Change& c) { return c.parameter == parameter; });
    if (!known)
        changes.push_back({.parameter = parameter, .before = parameters[parameter].exactValue()});
}

void SoundHistory::endGesture(ParameterId parameter) {
    followHost();
    gestures.reset(static_cast<std::size_t>(parameter));
    if (gestures.none() && openEdits == 0)
        closeEdit();
}

void SoundHistory::endAllGestures() {
    followHost();
    gestures.reset();
    openEdits = 0;
    closeEdit();
    editName.clear();
}

void SoundHistory::beginEdit(const std::string& name) {
    followHost();
    if (openEdits++ > 0)
        return;
    closeEdit();
    editName = name;
}

void SoundHistory::endEdit() {
    followHost();
    if (openEdits == 0 || --openEdits > 0)
        return;
    closeEdit();
    editName.clear();
}

void SoundHistory::audition(const std::function<void()>& load) {
    followHost();
    closeEdit();
    if (!beforeAudition)
        beforeAudition = session();
    load();
}

void SoundHistory::keepAudition() {
    followHost();
    if (const auto before = std::exchange(beforeAudition, std::nullopt)) {
        closeEdit();
        pushLoad(holder.loadedLabel().name, *before);
    }
}

void SoundHistory::endAudition() {
    followHost();
    if (const auto before = std::exchange(beforeAudition, std::nullopt)) {
        changes.clear();
        play(*before);
    }
}

} // namespace idiophone
