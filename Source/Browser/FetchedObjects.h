// The modal objects that a page has fetched.
#pragma once

#include "Instrument/ObjectSource.h"

#include <cstddef>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace idiophone {

/// One thread at a time. Objects stay as long as an instrument plays them; those that were added
/// last stay until `forgetUnplayed`.
class FetchedObjects final : public ObjectSource {
public:
    /// Reads a .modal file, or a .glb with a modal model, and keeps its object under a name. The
    /// error begins with the name.
    Result<std::shared_ptr<const ModalObject>> add(const std::string& name,
                                                   std::span<const std::byte> bytes);

    bool has(const std::string& name) override;
    Result<std::shared_ptr<const ModalObject>> find(const std::string& name) override;

    void forgetUnplayed() { added.clear(); }

private:
    std::map<std::string, std::weak_ptr<const ModalObject>> known;
    std::vector<std::shared_ptr<const ModalObject>> added;
};

} // namespace idiophone
