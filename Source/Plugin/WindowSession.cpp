#include "Plugin/WindowSession.h"

#include "Editor/SettingsFolder.h"

namespace idiophone {

WindowSession::WindowSession(SharedParts& shared, SoundSession& session)
    : controllers(shared.messages.controllers), history(session, shared.parameters, shared.loads),
      variants(session, history), edits(shared.plugin, shared.parameters, session, history),
      materials(shared.parameters, session, history, edits), instrument(shared, session),
      stage(shared, session), modes(shared, session, history),
      imports(shared, session, history, materials), kit(shared, session, history),
      materialFits(shared.parameters, session, imports, materials),
      tuning(shared, session, history), presets(session, history, imports, userSettingsFolder()),
      recorder(shared, session),
      samples(shared, session, tuning), view{.parameters = edits,
                                             .materials = materials,
                                             .materialFits = materialFits,
                                             .instrument = instrument,
                                             .stage = stage,
                                             .sound = modes,
                                             .workshop = imports,
                                             .kit = kit,
                                             .tuning = tuning,
                                             .presets = presets,
                                             .history = history,
                                             .variants = variants,
                                             .controllers = controllers,
                                             .recorder = recorder,
                                             .samples = samples,
                                             .status = session} {}

void WindowSession::poll() {
    instrument.poll();
    imports.poll();
    materialFits.poll();
    recorder.poll();
    samples.poll();
}

} // namespace idiophone
