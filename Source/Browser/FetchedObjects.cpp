#include "Browser/FetchedObjects.h"

#include "Gltf/ObjectBytes.h"
#include "Object/OneLine.h"

namespace idiophone {

Result<std::shared_ptr<const ModalObject>> FetchedObjects::add(const std::string& name,
                                                               std::span<const std::byte> bytes) {
    auto object = readObject(bytes, name);
    if (!object)
        return tl::unexpected(object.error());
    auto kept = std::make_shared<const ModalObject>(std::move(*object));
    known[name] = kept;
    added.push_back(kept);
    return kept;
}

bool FetchedObjects::has(const std::string& name) {
    const auto found = known.find(name);
    return found != known.end() && !found->second.expired();
}

Result<std::shared_ptr<const ModalObject>> FetchedObjects::find(const std::string& name) {
    const auto found = known.find(name);
    if (auto object = found == known.end() ? nullptr : found->second.lock())
        return object;
    return failure("there is no object " + inQuotes(name));
}

} // namespace idiophone
