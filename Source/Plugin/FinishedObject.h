// Objects from files that need no mesh analysis: modal objects, and recordings of a strike.
#pragma once

#include "Object/ModalObject.h"
#include "Object/WorkControl.h"

#include <filesystem>

namespace idiophone {

/// Reads a modal object (`readObject`), or fits the modes of a recording (RecordingFit). The object
/// of a recording is a small disc that sounds as recorded wherever it is struck. The error is one
/// sentence that names the file, or a cancellation. Takes seconds; any thread but the audio thread.
Result<ModalObject> finishedObject(const std::filesystem::path& file, const WorkControl& control);

} // namespace idiophone
