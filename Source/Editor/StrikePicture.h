// Draws strikes: mallets, lights, and the discs that turn while bars sound.
#pragma once

#include "Editor/MalletAppearance.h"
#include "Editor/MalletSwings.h"
#include "Editor/ObjectScene.h"
#include "Editor/ProcessorView.h"
#include "Editor/StrikeGlows.h"
#include "Editor/StrikeWatch.h"

#include <cmath>
#include <juce_audio_basics/juce_audio_basics.h>
#include <numbers>
#include <vector>

namespace idiophone {

/// For the message thread.
class StrikePicture {
public:
    explicit StrikePicture(ProcessorView& processor) : view(processor) {}

    /// Takes the objects of a scene, silent.
    void reset(const ObjectScene& scene, bool isOnStage) {
        std::vector<float> radii;
        for (const auto& object : scene.objects())
            radii.push_back(object.radius);
        onStage = isOnStage;
        glows.reset(std::move(radii), onStage);
        swings.reset();
        watch.reset();
        byHand = {};
    }
    /// The hand strikes a place.
    void strike(const ScenePick& pick, const ObjectScene& scene, float strength) {
        touch(pick);
        // Bars are struck from above, at their sides too.
        const bool isBar = scene.objects()[pick.object].form == Form::box;
        swings.strike(pick.place, isBar ? ScenePlace{0, 0, 1} : pick.normal, strength);
    }
    /// The hand scrapes over a place.
    void touch(const ScenePick& pick) {
        byHand = {pick.object, secondsToHear};
        glows.strike(pick.object, pick.place);
    }
    /// Follows the sound. Returns whether the picture has changed.
    bool follow(const SoundFrame& frame,
                const std::vector<InstrumentView::PlayedObject>& played,
                const ObjectScene& scene) {
        secondsWithoutFrame = 0;
        std::vector<float> loudness(played.size(), 0);
        for (const auto& slot : frame.slots)
            if (const auto object = static_cast<std::size_t>(slot.object); object < loudness.size())
                loudness[object] = std::max(loudness[object], loudnessOf(slot));
        for (const auto& slot : watch.follow(frame.slots))
            showKeyStrike(slot, played, scene);
        return glows.follow(loudness) || moves();
    }

    /// Whether mallets, lights or discs move.
    bool moves() const { return swings.moves() || glows.moves() || discsTurn(); }
    void advance(double seconds) {
        swings.advance(seconds);
        glows.advance(seconds);
        byHand.seconds -= seconds;
        secondsWithoutFrame += seconds;
        if (discsTurn())
            discTurns = std::remainder(
                discTurns + seconds * view.parameters.value(ParameterId::motorSpeed), 1.0);
    }
    /// Adds all of it to a frame. `reach` is the scene's radius in metres.
    void addTo(SceneFrame& frame, float reach) const {
        constexpr double openTurns = 0.25; // discs stand upright
        constexpr float stickMetres = 0.38f, stickShare = 1.1f;
        const auto radius =
            static_cast<float>(view.parameters.effectiveValue(ParameterId::malletRadius) * 1e-3);
        frame.glows = glows.glows();
        frame.mallets = swings.mallets(radius, std::min(stickMetres, stickShare * reach));
        frame.malletHead = malletAppearance(view);
        frame.discRadians = static_cast<float>(2 * std::numbers::pi * (discTurns + openTurns));
    }

private:
    static constexpr double secondsToHear = 0.3; ///< until the sound of the hand has arrived

    static float loudnessOf(const SlotNow& slot) {
        constexpr float darkDecibels = -60; // an object at or below this level is not lit
        return 1 - juce::Decibels::gainToDecibels(slot.amplitude, darkDecibels) / darkDecibels;
    }
    bool discsTurn() const {
        constexpr double secondsToStop = 0.5; // if the host stops the sound
        return glows.sounds() && secondsWithoutFrame < secondsToStop &&
               view.parameters.value(ParameterId::motorDepth) > 0;
    }
    /// Shows the strike of a key, unless the hand has shown it.
    void showKeyStrike(const SlotNow& slot,
                       const std::vector<InstrumentView::PlayedObject>& played,
                       const ObjectScene& scene) {
        const auto object = static_cast<std::size_t>(slot.object);
        if (onStage || object >= played.size() || (byHand.object == object && byHand.seconds > 0))
            return;
        const auto places = view.instrument.struckPlaces(object);
        if (places.empty())
            return;
        const auto& own = played[object];
        const double along = view.parameters.value(ParameterId::strikeAlong) / 200;
        const double key =
            own.highestNote > own.lowestNote && slot.note >= 0
                ? double(slot.note - own.lowestNote) / double(own.highestNote - own.lowestNote)
                : 0.5;
        const auto index = static_cast<std::size_t>(
            std::lround(std::clamp(key + along, 0.0, 1.0) * double(places.size() - 1)));
        const auto place = scene.placeOf(object, places[index]);
        glows.strike(object, place);
        swings.strike(place, scene.normalAt(place), loudnessOf(slot));
    }

    ProcessorView& view;
    MalletSwings swings;
    StrikeGlows glows;
    StrikeWatch watch;
    struct {
        std::size_t object = 0;
        double seconds = 0; ///< until its sound has arrived
    } byHand;
    double discTurns = 0;
    double secondsWithoutFrame = 0; ///< since the last frame of the sound
    bool onStage = false;
};

} // namespace idiophone
