// Keeps undo and redo steps for all changes of the sound in the window. It stores sounds; the
// holder plays them.
#pragma once

#include "Editor/EditHistory.h"
#include "Plugin/HostLoads.h"
#include "Plugin/HostParameters.h"
#include "Plugin/Sound.h"

#include <bitset>
#include <functional>
#include <juce_data_structures/juce_data_structures.h>
#include <optional>

namespace idiophone {

/// The variant of A and B that does not play, if it was made, and whether B plays.
struct OtherVariant {
    std::optional<Sound> sound;
    bool playsB = false;

    bool operator==(const OtherVariant&) const = default;
};

/// For the message thread. A state or program loaded by the host clears all steps and the other
/// variant. Programs that MIDI asks for are a step. Consecutive ones are one step, because a song
/// may change them all the time.
class SoundHistory final : public EditHistory {
public:
    /// Does not call the holder yet.
    SoundHistory(SoundHolder& holder, HostParameters& parameters, HostLoads& hostLoads);

    bool canUndo() override;
    bool canRedo() override;
    std::string undoName() override;
    std::string redoName() override;
    void undo() override;
    void redo() override;
    void beginEdit(const std::string& name) override;
    void endEdit() override;

    /// A change by hand starts with `beginGesture` and ends with `endGesture`. Call `willChange`
    /// before each change between them.
    void beginGesture(ParameterId parameter);
    void willChange(ParameterId parameter);
    void endGesture(ParameterId parameter);
    /// Ends all open gestures and edits, such as those of a closed window.
    void endAllGestures();

    /// Calls `load`, which plays another sound, as one step of that name. Makes no step if the
    /// sound stays the same, for example after a failure.
    void record(const std::string& name, const std::function<void()>& load);

    /// Makes one step of a finished change outside the sound.
    void recordDone(const std::string& name,
                    const std::function<void()>& undone,
                    const std::function<void()>& doneAgain);

    /// Returns whether B plays. A new session begins with A.
    bool playsB();
    /// Call it within `record`, so that a change belongs to its step.
    OtherVariant& otherVariant() noexcept { return other; }

    /// Passes every sound of the steps and the other variant through `renew`, and makes no step.
    /// Use it for data that is replaced for good: a preview by the whole analysis, or a preset file
    /// by saving. The caller renews the current sound.
    void renewSounds(const std::function<void(Sound&)>& renew);

    /// Plays sounds for listening, without steps. `keepAudition` makes one step of all of them;
    /// `endAudition` returns to the sound before. Without an audition both do nothing.
    void audition(const std::function<void()>& load);
    void keepAudition();
    void endAudition();

private:
    class Step;
    struct Session {
        Sound playing;
        OtherVariant other;

        bool operator==(const Session&) const = default;
    };
    struct LoadedSessions {
        Session before, after;
    };
    struct Change {
        ParameterId parameter;
        double before = 0, after = 0;
    };

    Session session() const { return {.playing = holder.loadedSound(), .other = other}; }
    /// Plays a session and returns whether that succeeded. If a step fails, all steps are cleared.
    bool play(const Session& wanted);
    void followHost();
    void beginStep();
    void forgetAll();
    void recordPrograms(Sound before);
    /// Closes the open edit, with the present values or those given.
    void closeEdit(const ParameterValues* values = nullptr);
    void push(Step* step, const std::string& name);
    /// Returns whether there is anything to undo.
    bool pushLoad(const std::string& name, const Session& before);

    SoundHolder& holder;
    HostParameters& parameters;
    HostLoads& hostLoads;
    juce::UndoManager steps;
    std::vector<std::weak_ptr<LoadedSessions>> loads; ///< sessions of the steps still kept
    int knownHostLoads = -1;                          ///< host loads counted before the steps
    std::weak_ptr<LoadedSessions> programs; ///< sessions of the newest step, if MIDI made it

    OtherVariant other;
    std::optional<Session> beforeAudition;

    std::bitset<parameterCount> gestures; ///< open gestures
    int openEdits = 0;
    std::string editName;
    std::vector<Change> changes; ///< of the open edit or gesture
};

} // namespace idiophone
