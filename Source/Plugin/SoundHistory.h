// Undo and redo of all that is done to the sound in the window, and its A and B. It remembers; the
// processor plays.
#pragma once

#include "Editor/EditHistory.h"
#include "Editor/SoundVariants.h"
#include "Plugin/Sound.h"

#include <bitset>
#include <functional>
#include <juce_data_structures/juce_data_structures.h>
#include <optional>

namespace idiophone {

/// What plays, what it is compared with, and which of them is B.
struct Session {
    Sound playing;
    std::optional<Sound> other;
    bool playsB = false;

    bool operator==(const Session&) const = default;
};

/// For the message thread. The host's states and programs, of which the holder counts the loads,
/// forget all steps and the other variant. Programs that MIDI asks for are a step, those in a row
/// a single one, as a song may go on changing them.
class SoundHistory final : public EditHistory, public SoundVariants {
public:
    /// Asks nothing of the holder yet.
    explicit SoundHistory(SoundHolder& holder);
    ~SoundHistory() override;

    bool canUndo() override;
    bool canRedo() override;
    std::string undoName() override;
    std::string redoName() override;
    void undo() override;
    void redo() override;
    void beginEdit(const std::string& name) override;
    void endEdit() override;

    bool playsB() override;
    void compare() override;
    void copyToOther() override;
    void mutate(double strength, std::uint32_t seed) override;

    /// Between these two a parameter changes by hand, of which `willChange` tells every time,
    /// before.
    void beginGesture(ParameterId parameter);
    void willChange(ParameterId parameter);
    void endGesture(ParameterId parameter);
    /// Ends whatever gestures and edits have not ended, as those of a window that was closed.
    void endAllGestures();

    /// Does something that plays another sound, as one step of that name; none where the sound is
    /// the same afterwards, as when it failed.
    void record(const std::string& name, const std::function<void()>& load);

    /// One step of something beside the sound, which is done already.
    void recordDone(const std::string& name,
                    std::function<void()> undone,
                    std::function<void()> doneAgain);

    /// What sounds refer to has been replaced for good, for what plays too, as the preview of an
    /// analysis by its end or what the file of a preset held by what was saved: every sound that
    /// the steps and the other variant know passes through `renew`. No step.
    void renewSounds(const std::function<void(Sound&)>& renew);

    /// Plays sounds to listen to, without steps, until `keepAudition`, which makes one step of them
    /// all, or `endAudition`, which returns to what played before. Without an audition under way
    /// both do nothing.
    void audition(const std::function<void()>& load);
    void keepAudition();
    void endAudition();

private:
    class ParameterStep;
    class LoadStep;
    class DoneStep;
    struct LoadedSessions {
        Session before, after;
    };
    struct Change {
        ParameterId parameter;
        double before = 0, after = 0;
    };

    Session session() const;
    /// Returns whether it plays. Steps that fail are forgotten, with all others.
    bool play(const Session& wanted);
    void change(const std::vector<Change>& changes, bool forward);
    void followHolder();
    void forgetAll();
    void recordPrograms(Sound before);
    void closeEdit();
    /// With these values at its end.
    void closeEdit(const std::function<double(ParameterId)>& valueOf);
    void push(juce::UndoableAction* step, const std::string& name);
    /// Returns whether there is anything to take back.
    bool pushLoad(const std::string& name, const Session& before);

    SoundHolder& holder;
    juce::UndoManager steps;
    std::vector<std::weak_ptr<LoadedSessions>> loads; ///< of the steps that live
    int knownHostLoads = -1;                          ///< that came before the steps
    std::weak_ptr<LoadedSessions> programs; ///< of the newest step, if it is one of MIDI's

    std::optional<Sound> other;
    bool isB = false;
    std::optional<Session> beforeAudition;

    std::bitset<parameterCount> gestures; ///< under way
    int openEdits = 0;
    std::string editName;
    std::vector<Change> changes; ///< of the edit or gesture under way
};

} // namespace idiophone
