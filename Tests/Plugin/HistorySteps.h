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
    processor.beginParameterChange(parameter);
    for (const double value : values)
        processor.changeParameter(parameter, value);
    processor.endParameterChange(parameter);
}

inline ParameterValues valuesOf(const Processor& processor) {
    return processor.loadedSound().parameters;
}

inline void load(Processor& processor, std::size_t preset) {
    REQUIRE(processor.presetShelf().loadPreset(factoryPresetId(factoryPresets()[preset].name)));
}

} // namespace idiophone::test
