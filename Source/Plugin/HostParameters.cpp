#include "Plugin/HostParameters.h"

namespace idiophone {

HostParameters::HostParameters(juce::AudioProcessor& processor, MakeParameter make) {
    for (const auto& info : parameterTable()) {
        auto parameter = make(info);
        parameters[static_cast<std::size_t>(info.parameter)] = parameter.get();
        processor.addParameter(parameter.release());
    }
}

ParameterValues HostParameters::values() const noexcept {
    ParameterValues result;
    for (const auto* parameter : parameters)
        result.set(parameter->info().parameter, parameter->exactValue());
    return result;
}

ParameterValues HostParameters::modulatedValues() const noexcept {
    ParameterValues result;
    for (const auto* parameter : parameters)
        result.set(parameter->info().parameter, parameter->modulatedValue());
    return result;
}

void HostParameters::load(const ParameterValues& values) noexcept {
    ++loads;
    for (auto* parameter : parameters)
        parameter->setExactValue(values[parameter->info().parameter]);
    ++loads;
}

void HostParameters::loadChanges(const ParameterValues& before,
                                 const ParameterValues& after) noexcept {
    ++loads;
    for (auto* parameter : parameters) {
        const auto id = parameter->info().parameter;
        if (after[id] != before[id])
            parameter->setExactValue(after[id]);
    }
    ++loads;
}

ParameterValues HostParameters::valuesAfter(const ParameterValues& before,
                                            const ParameterValues& after) const noexcept {
    auto result = values();
    for (const auto& info : parameterTable())
        if (after[info.parameter] != before[info.parameter])
            result.set(info.parameter, after[info.parameter]);
    return result;
}

HostParameters::Moves HostParameters::moves() const noexcept {
    Moves result;
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] = parameters[i]->moves();
    return result;
}

ParameterValues HostParameters::withMoved(const Moves& since,
                                          ParameterValues values) const noexcept {
    for (std::size_t i = 0; i < since.size(); ++i)
        if (parameters[i]->moves() != since[i])
            values.set(parameters[i]->info().parameter, parameters[i]->exactValue());
    return values;
}

void HostParameters::sendValues() const {
    for (auto* parameter : parameters)
        parameter->sendValue();
}

void HostParameters::sendMovedValues() const {
    for (auto* parameter : parameters)
        parameter->sendValueIfMoved();
}

void HostParameters::forgetLastSent() const noexcept {
    for (auto* parameter : parameters)
        parameter->forgetLastSent();
}

void HostParameters::read(ParameterValues& current) const noexcept {
    const auto before = loads.load();
    const auto fresh = modulatedValues();
    if (before % 2 == 0 && loads.load() == before)
        current = fresh;
}

} // namespace idiophone
