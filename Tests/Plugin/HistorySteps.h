// Actions of a user in the window, for tests of the history.
#pragma once

#include "Instrument/FactoryContent.h"
#include "Plugin/FactoryPrograms.h"
#include "Plugin/Processor.h"

#include <catch2/catch_test_macros.hpp>
#include <initializer_list>

namespace idiophone::test {

inline void
drag(Processor& processor, ParameterId parameter, std::initializer_list<double> values) {
    processor.view().parameters.beginChange(parameter);
    for (const double value : values)
        processor.view().parameters.change(parameter, value);
    processor.view().parameters.endChange(parameter);
}

inline ParameterValues valuesOf(Processor& processor) {
    return processor.soundSession().loadedSound().parameters;
}

inline void load(Processor& processor, std::size_t preset) {
    REQUIRE(processor.view().presets.loadPreset(factoryPresetId(factoryPresets()[preset].name)));
}

} // namespace idiophone::test
