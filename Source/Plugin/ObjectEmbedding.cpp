#include "Plugin/ObjectEmbedding.h"

#include "Instrument/FactoryContent.h"
#include "Object/ModalObjectFile.h"

#include <mutex>
#include <set>

namespace idiophone {
std::vector<EmbeddedObject> foreignObjects(const Instrument& instrument) {
    std::vector<EmbeddedObject> objects;
    std::set<std::string> known;
    const auto& map = instrument.keyMap();
    for (int note = map.lowestNote; note <= map.highestNote; ++note) {
        const int slot = instrument.key(note).slot;
        const auto name = map.objectFor(note);
        if (slot < 0 || factoryObject(name) || !known.insert(name).second)
            continue;
        const auto& object = *instrument.slots()[static_cast<std::size_t>(slot)].object;
        objects.push_back({.name = name, .modal = encodeModalObject(object)});
    }
    return objects;
}

Result<std::shared_ptr<const Instrument>>
buildInstrument(const KeyMap& keyMap, const std::vector<EmbeddedObject>& objects) {
    // Another instance may embed other objects under the same names: theirs must not come between
    // adding ours and building from them.
    static std::mutex mutex;
    const std::scoped_lock lock(mutex);
    auto& library = ObjectLibrary::shared();
    std::vector<std::shared_ptr<const ModalObject>> kept;
    for (const auto& embedded : objects) {
        if (factoryObject(embedded.name))
            continue;
        auto object = readModalObject(embedded.modal, embedded.name);
        if (!object)
            return tl::unexpected(object.error());
        kept.push_back(library.add(embedded.name, std::move(*object)));
    }
    return Instrument::build(keyMap, library);
}

} // namespace idiophone
