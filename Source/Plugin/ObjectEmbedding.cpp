#include "Plugin/ObjectEmbedding.h"

#include "Instrument/FactoryContent.h"
#include "Object/HalfFloat.h"
#include "Object/ModalObjectFile.h"
#include "Scene/SceneStage.h"

#include <algorithm>
#include <mutex>
#include <set>

namespace idiophone {
namespace {

/// Another instance may embed other objects under the same names: theirs must not come between
/// adding ours and building from them.
std::mutex& libraryMutex() {
    static std::mutex mutex;
    return mutex;
}

/// Half precision where it loses nothing, as of what the workshop makes.
ShapePrecision leastPrecision(const ModalObject& object) {
    const bool isHalf = std::ranges::all_of(
        object.shapes, [](float shape) { return shape == halfToFloat(floatToHalf(shape)); });
    return isHalf ? ShapePrecision::half : ShapePrecision::single;
}

} // namespace

std::vector<EmbeddedObject> foreignObjects(const Instrument& instrument) {
    std::vector<EmbeddedObject> objects;
    std::set<std::string> known;
    const auto& map = instrument.keyMap();
    if (map.kind == KeyMapKind::scene)
        return objects; // it names its objects itself
    for (int note = map.lowestNote; note <= map.highestNote; ++note) {
        const int slot = instrument.key(note).slot;
        const auto name = map.objectFor(note);
        if (slot < 0 || factoryObject(name) || !known.insert(name).second)
            continue;
        const auto& object = *instrument.slots()[static_cast<std::size_t>(slot)].object;
        objects.push_back(
            {.name = name, .modal = encodeModalObject(object, leastPrecision(object))});
    }
    return objects;
}

Result<std::shared_ptr<const Instrument>>
buildInstrument(const KeyMap& keyMap, const std::vector<EmbeddedObject>& objects) {
    const std::scoped_lock lock(libraryMutex());
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
    return buildInstrument(keyMap, library);
}

Result<std::shared_ptr<const Instrument>>
buildSingleObject(const KeyMap& keyMap, const std::shared_ptr<const ModalObject>& object) {
    const std::scoped_lock lock(libraryMutex());
    auto& library = ObjectLibrary::shared();
    library.add(keyMap.object, object);
    return buildInstrument(keyMap, library);
}

Result<std::shared_ptr<const Instrument>> rebuilt(const Instrument& from, const KeyMap& keyMap) {
    if (keyMap.kind == KeyMapKind::scene)
        return buildInstrument(keyMap, ObjectLibrary::shared());
    const std::scoped_lock lock(libraryMutex());
    auto& library = ObjectLibrary::shared();
    const auto& map = from.keyMap();
    for (int note = map.lowestNote; note <= map.highestNote; ++note)
        if (const int slot = from.key(note).slot; slot >= 0)
            library.add(map.objectFor(note), from.slots()[static_cast<std::size_t>(slot)].object);
    return buildInstrument(keyMap, library);
}

} // namespace idiophone
