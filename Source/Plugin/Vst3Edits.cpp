#include "Plugin/Vst3Edits.h"

#include <pluginterfaces/vst/ivsteditcontroller.h>

namespace idiophone {

void Vst3Edits::setIComponentHandler(Steinberg::FUnknown* handler) {
    if (handler != nullptr)
        handler->addRef();
    host = {handler, [](Steinberg::FUnknown* kept) {
                if (kept != nullptr)
                    kept->release();
            }};
}

bool Vst3Edits::send(const HostParameters& parameters) const {
    const auto handler = host; // the host may set another one while it is told
    if (handler == nullptr)
        return false;
    auto& edits = static_cast<Steinberg::Vst::IComponentHandler&>(*handler);
    for (const auto& info : parameterTable())
        edits.performEdit(convertJuceParameterId(info.id), parameters[info.parameter].getValue());
    return true;
}

} // namespace idiophone
