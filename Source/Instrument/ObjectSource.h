// A source in which instruments and scenes find modal objects by name.
#pragma once

#include "Object/ModalObject.h"
#include "Object/Result.h"

#include <memory>
#include <string>

namespace idiophone {

/// Not for the audio thread.
class ObjectSource {
public:
    virtual ~ObjectSource() = default;

    /// Returns whether `find` has an object, or a file to read, under that name.
    virtual bool has(const std::string& name) = 0;

    /// Returns the object of that name. The error names it.
    virtual Result<std::shared_ptr<const ModalObject>> find(const std::string& name) = 0;
};

} // namespace idiophone
