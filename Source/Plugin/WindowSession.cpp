#include "Plugin/WindowSession.h"

#include "Editor/SettingsFolder.h"

namespace idiophone {

WindowSession::WindowSession(HostParameters& parameters,
                             EngineMessages& messages,
                             EngineReport& report,
                             TailLength& tail,
                             HostReporter& reporter,
                             HostLoads& hostLoads,
                             SoundSession& session)
    : controllers(messages.controllers), history(session, parameters, hostLoads),
      variants(session, history), edits(parameters, session, history),
      materials(parameters, session, history, edits), instrument(session, messages, report),
      stage(session, messages, report),
      modes(parameters, session, reporter, history, report.monitor),
      imports(parameters, session, reporter, history, materials),
      tuning(session, tail, messages.tuner, reporter, history),
      presets(session, history, imports, userSettingsFolder()), view{.parameters = edits,
                                                                     .materials = materials,
                                                                     .instrument = instrument,
                                                                     .stage = stage,
                                                                     .sound = modes,
                                                                     .workshop = imports,
                                                                     .tuning = tuning,
                                                                     .presets = presets,
                                                                     .history = history,
                                                                     .variants = variants,
                                                                     .controllers =
                                                                         messages.controllers,
                                                                     .status = session} {}

void WindowSession::poll() {
    instrument.poll();
    imports.poll();
}

} // namespace idiophone
