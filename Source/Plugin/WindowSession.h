// Everything that the window uses of the processor, one member for each purpose.
#pragma once

#include "Editor/ProcessorView.h"
#include "Plugin/ImportSession.h"
#include "Plugin/InstrumentSession.h"
#include "Plugin/KitSession.h"
#include "Plugin/MaterialFitSession.h"
#include "Plugin/MaterialSession.h"
#include "Plugin/ModeSession.h"
#include "Plugin/ParameterEdits.h"
#include "Plugin/PresetCollection.h"
#include "Plugin/RecorderSession.h"
#include "Plugin/SampleSession.h"
#include "Plugin/SoundHistory.h"
#include "Plugin/StageSession.h"
#include "Plugin/TuningSession.h"
#include "Plugin/VariantSession.h"

namespace idiophone {

/// For the message thread.
struct WindowSession {
    WindowSession(SharedParts& shared, SoundSession& session);

    /// Call it regularly.
    void poll();

    MidiLearn& controllers;
    SoundHistory history;
    VariantSession variants;
    ParameterEdits edits;
    MaterialSession materials;
    InstrumentSession instrument;
    StageSession stage;
    ModeSession modes;
    ImportSession imports;
    KitSession kit;
    MaterialFitSession materialFits;
    TuningSession tuning;
    PresetCollection presets;
    RecorderSession recorder;
    SampleSession samples;
    ProcessorView view;
};

} // namespace idiophone
