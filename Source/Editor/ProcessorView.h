// The editor's only access to the processor: one interface for each purpose. Plugin implements
// them.
#pragma once

#include "Editor/EditHistory.h"
#include "Editor/InstrumentView.h"
#include "Editor/KitView.h"
#include "Editor/MaterialFitView.h"
#include "Editor/MaterialView.h"
#include "Editor/MidiLearnView.h"
#include "Editor/ParameterView.h"
#include "Editor/PresetShelf.h"
#include "Editor/RecorderView.h"
#include "Editor/SampleView.h"
#include "Editor/SoundVariants.h"
#include "Editor/SoundView.h"
#include "Editor/StageView.h"
#include "Editor/StatusView.h"
#include "Editor/TuningView.h"
#include "Editor/WorkshopView.h"

namespace idiophone {

/// For the message thread. All live as long as the processor.
struct ProcessorView {
    ParameterView& parameters;
    MaterialView& materials;
    MaterialFitView& materialFits;
    InstrumentView& instrument;
    StageView& stage;
    SoundView& sound;
    WorkshopView& workshop;
    KitView& kit;
    TuningView& tuning;
    PresetShelf& presets;
    EditHistory& history;
    SoundVariants& variants;
    MidiLearnView& controllers;
    RecorderView& recorder;
    SampleView& samples;
    StatusView& status;
};

} // namespace idiophone
