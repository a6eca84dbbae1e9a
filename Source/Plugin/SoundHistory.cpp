#include "Plugin/SoundHistory.h"

#include "Editor/Utf8.h"

#include <algorithm>
#include <limits>
#include <set>

namespace idiophone {
namespace {

// Limits of juce::UndoManager, in KiB. It always keeps the newest steps.
constexpr int mostUnits = 512 * 1024, fewestSteps = 8;
constexpr int unitsOfParameters = 64; // more than their size, so that at most 8192 steps are kept
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

/// A step in which some parameters changed together.
class SoundHistory::ParameterStep final : public juce::UndoableAction {
public:
    ParameterStep(SoundHistory& owner, std::vector<Change> done)
        : history(owner), changes(std::move(done)) {}

    bool perform() override {
        if (std::exchange(isDone, true)) // the first time, the user has done it already
            history.change(changes, true);
        return true;
    }
    bool undo() override {
        history.change(changes, false);
        return true;
    }
    int getSizeInUnits() override { return unitsOfParameters; }

private:
    SoundHistory& history;
    std::vector<Change> changes;
    bool isDone = false;
};

/// A step from one session to another.
class SoundHistory::LoadStep final : public juce::UndoableAction {
public:
    LoadStep(SoundHistory& owner, std::shared_ptr<LoadedSessions> done)
        : history(owner), sessions(std::move(done)) {
        const auto& [before, after] = *sessions;
        units = unitsOfSound;
        if (before.playing.instrument != after.playing.instrument)
            units += unitsOfObjects(before.playing);
    }

    bool perform() override {
        return !std::exchange(isDone, true) || history.play(sessions->after);
    }
    bool undo() override { return history.play(sessions->before); }
    int getSizeInUnits() override { return units; }

private:
    SoundHistory& history;
    std::shared_ptr<LoadedSessions> sessions;
    int units;
    bool isDone = false;
};

/// A step of a change outside the sound.
class SoundHistory::DoneStep final : public juce::UndoableAction {
public:
    DoneStep(std::function<void()> undoIt, std::function<void()> doItAgain)
        : undone(std::move(undoIt)), doneAgain(std::move(doItAgain)) {}

    bool perform() override {
        if (std::exchange(isDone, true))
            doneAgain();
        return true;
    }
    bool undo() override {
        undone();
        return true;
    }
    int getSizeInUnits() override { return unitsOfTunings; }

private:
    std::function<void()> undone, doneAgain;
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
                              std::function<void()> undone,
                              std::function<void()> doneAgain) {
    endAudition();
    followHost();
    closeEdit();
    push(new DoneStep(std::move(undone), std::move(doneAgain)), name);
}

void SoundHistory::renewSounds(const std::function<void(Sound&)>& renew) {
    const auto renewIn = [&](Session& kept) {
        renew(kept.playing);
        if (kept.other)
            renew(*kept.other);
    };
    for (const auto& known : loads)
        if (const auto sessions = known.lock()) {
            renewIn(sessions->before);
            renewIn(sessions->after);
        }
    if (other)
        renew(*other);
    if (beforeAudition)
        renewIn(*beforeAudition);
}

Session SoundHistory::session() const {
    return {.playing = holder.loadedSound(), .other = other, .playsB = isB};
}

bool SoundHistory::play(const Session& wanted) {
    if (holder.loadedSound() != wanted.playing && !holder.playSound(wanted.playing))
        return false;
    other = wanted.other;
    isB = wanted.playsB;
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
    closeEdit([values = before.parameters](ParameterId parameter) { return values[parameter]; });
    const auto from =
        std::exchange(beforeAudition, std::nullopt)
            .value_or(Session{.playing = std::move(before), .other = other, .playsB = isB});
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
    other.reset();
    isB = false;
    beforeAudition.reset();
    changes.clear();
}

void SoundHistory::closeEdit() {
    closeEdit([this](ParameterId parameter) { return parameters[parameter].exactValue(); });
}

void SoundHistory::closeEdit(const std::function<double(ParameterId)>& valueOf) {
    auto done = std::exchange(changes, {});
    for (auto& change : done)
        change.after = valueOf(change.parameter);
    std::erase_if(done, [](const Change& change) { return change.after == change.before; });
    if (done.empty())
        return;
    const auto name = !editName.empty()  ? editName
                      : done.size() == 1 ? std::string(parameterInfo(done.front().parameter).name)
                                         : std::to_string(done.size()) + " parameters";
    push(new ParameterStep(*this, std::move(done)), name);
}

void SoundHistory::push(juce::UndoableAction* step, const std::string& name) {
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
    push(new LoadStep(*this, std::move(sessions)), name);
    return true;
}

} // namespace idiophone
