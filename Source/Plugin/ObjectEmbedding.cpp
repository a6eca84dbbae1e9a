#include "Plugin/ObjectEmbedding.h"

#include "Instrument/FactoryContent.h"
#include "Instrument/ObjectLibrary.h"
#include "Instrument/PresetFile.h"
#include "Object/FileBytes.h"
#include "Object/HalfFloat.h"
#include "Object/ModalObjectFile.h"
#include "Object/OneLine.h"
#include "Plugin/WithinMemory.h"
#include "Scene/FactoryScenes.h"
#include "Scene/SceneFile.h"
#include "Scene/SceneStage.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <mutex>
#include <set>
#include <utility>

namespace idiophone {
namespace {

/// Caches the packed text of every living object: hosts ask for states often, and packing is slow.
class PackedObjects {
public:
    using Text = std::shared_ptr<const std::string>;

    static PackedObjects& shared() {
        static PackedObjects packed;
        return packed;
    }

    Text of(const std::shared_ptr<const ModalObject>& object) {
        if (auto known = find(object))
            return known;
        // Pack without the lock, so that other threads need not wait.
        auto text = std::make_shared<const std::string>(packedModal(modalFile(*object)));
        keep(object, text);
        return text;
    }

    void keep(const std::shared_ptr<const ModalObject>& object, Text text) {
        forgetGone();
        const std::scoped_lock lock(mutex);
        texts[object] = std::move(text);
    }

    /// Drops the texts of objects that live no more.
    void forgetGone() {
        const std::scoped_lock lock(mutex);
        std::erase_if(texts, [](const auto& entry) { return entry.first.expired(); });
    }

private:
    Text find(const std::shared_ptr<const ModalObject>& object) {
        const std::scoped_lock lock(mutex);
        const auto found = texts.find(object);
        return found == texts.end() ? nullptr : found->second;
    }

    std::mutex mutex;
    std::map<std::weak_ptr<const ModalObject>, Text, std::owner_less<>> texts;
};

bool isFile(const std::string& name) {
    std::error_code fault;
    return std::filesystem::exists(pathNamed(name), fault);
}

std::string shown(const std::string& name) {
    constexpr std::size_t longest = 97;
    return name.size() > longest ? "..." + oneLine(name.substr(name.size() - longest))
                                 : oneLine(name);
}

/// Returns the first file that a scene names and this machine lacks.
std::optional<std::string> firstMissingIn(const Scene& scene) {
    for (const auto& kind : scene.kinds)
        if (kind.given == nullptr && !factoryObject(kind.object) && !isFile(kind.object))
            return shown(kind.object);
    if (!scene.keyboard || findFactoryPreset(scene.keyboard->preset) != nullptr)
        return std::nullopt;
    if (!isFile(scene.keyboard->preset))
        return shown(scene.keyboard->preset);
    const auto file = pathNamed(scene.keyboard->preset);
    const auto preset = readPresetFile(file);
    // Only a `bars` preset can be a keyboard. Checking a scene preset could recurse without end.
    return preset && preset->keyMap.kind == KeyMapKind::bars
               ? firstMissing(withObjectsBeside(preset->keyMap, file), {})
               : std::nullopt;
}

bool isGiven(const std::string& name, const std::vector<EmbeddedObject>& objects) {
    return std::ranges::find(objects, name, &EmbeddedObject::name) != objects.end();
}

/// Returns the first network path that a state names without embedding it. The path is not even
/// probed, because anybody may have written the state.
std::optional<std::string> firstInNetwork(const KeyMap& keyMap,
                                          const std::vector<EmbeddedObject>& objects) {
    for (const auto& name : objectNames(keyMap))
        if (leadsIntoNetwork(name) && (keyMap.kind == KeyMapKind::scene || !isGiven(name, objects)))
            return shown(name);
    return std::nullopt;
}

/// Returns an upper bound on the size of its .modal file.
std::size_t largestFileBytes(const ModalObject& object) {
    constexpr std::size_t largestHeader = 1 << 20;
    const auto& radiation = object.radiation;
    return largestHeader +
           sizeof(double) *
               (object.eigenvalues.size() + object.bending.size() + object.decaysPerSecond.size() +
                object.extraDecaysPerSecond.size() + radiation.frequencyRatios.size()) +
           sizeof(float) * (object.shapes.size() + object.vertices.size() + object.faces.size() +
                            object.shapeVertices.size() + 2 * radiation.weights.size() +
                            2 * object.gains.size() + 3 * radiation.directions.size());
}

} // namespace

std::vector<ForeignObject> foreignObjects(const Instrument& instrument) {
    std::vector<ForeignObject> objects;
    std::set<std::string> known;
    if (instrument.keyMap().kind == KeyMapKind::scene)
        return objects; // a scene names its objects itself
    const auto slots = instrument.slots();
    for (std::size_t slot = 0; slot < slots.size(); ++slot)
        if (const auto& name = instrument.objectName(slot);
            !factoryObject(name) && known.insert(name).second)
            objects.push_back({.name = name, .object = slots[slot].object});
    return objects;
}

std::vector<std::byte> modalFile(const ModalObject& object) {
    const bool isHalf = std::ranges::all_of(
        object.shapes, [](float shape) { return shape == halfToFloat(floatToHalf(shape)); });
    return encodeModalObject(object, isHalf ? ShapePrecision::half : ShapePrecision::single);
}

std::vector<EmbeddedObject> embeddedObjects(const Instrument& instrument) {
    PackedObjects::shared().forgetGone();
    std::vector<EmbeddedObject> objects;
    for (const auto& [name, object] : foreignObjects(instrument))
        objects.push_back(
            {.name = name, .modal = {}, .packed = PackedObjects::shared().of(object)});
    return objects;
}

Result<std::shared_ptr<const Instrument>>
fitForState(std::shared_ptr<const Instrument> instrument) {
    std::size_t bytes = 0;
    for (const auto& [name, object] : foreignObjects(*instrument))
        bytes += largestFileBytes(*object);
    if (bytes > static_cast<std::size_t>(largestEmbeddedBytes))
        return failure("its objects take more than the 1 GiB that a project can hold");
    return instrument;
}

Result<std::shared_ptr<const Instrument>>
buildInstrument(const KeyMap& keyMap, const std::vector<EmbeddedObject>& objects) {
    return withinMemory([&]() -> Result<std::shared_ptr<const Instrument>> {
        ObjectLibrary library(ObjectLibrary::shared());
        std::vector<std::shared_ptr<const ModalObject>> kept;
        for (const auto& embedded : objects) {
            if (factoryObject(embedded.name))
                continue;
            auto object = readModalObject(embedded.modal, embedded.name);
            if (!object)
                return tl::unexpected(object.error());
            kept.push_back(library.add(embedded.name, std::move(*object)));
            if (embedded.packed != nullptr)
                PackedObjects::shared().keep(kept.back(), embedded.packed);
        }
        return buildInstrument(keyMap, library).and_then(fitForState);
    });
}

Result<std::shared_ptr<const Instrument>>
buildSingleObject(const KeyMap& keyMap, const std::shared_ptr<const ModalObject>& object) {
    return withinMemory([&] {
        ObjectLibrary library(ObjectLibrary::shared());
        library.add(keyMap.object, object);
        return buildInstrument(keyMap, library).and_then(fitForState);
    });
}

Result<std::shared_ptr<const Instrument>> rebuilt(const Instrument& from, const KeyMap& keyMap) {
    return withinMemory([&] {
        ObjectLibrary library(ObjectLibrary::shared());
        if (keyMap.kind == KeyMapKind::scene)
            return buildInstrument(keyMap, library);
        const auto slots = from.slots();
        for (std::size_t slot = 0; slot < slots.size(); ++slot)
            library.add(from.objectName(slot), slots[slot].object);
        return buildInstrument(keyMap, library);
    });
}

std::optional<std::string> firstMissing(const KeyMap& keyMap,
                                        const std::vector<EmbeddedObject>& objects) {
    if (keyMap.kind == KeyMapKind::scene) {
        if (findFactoryScene(keyMap.object) != nullptr)
            return std::nullopt;
        const auto file = sceneFileNamed(keyMap.object);
        std::error_code fault;
        if (!std::filesystem::exists(file, fault))
            return shown(keyMap.object);
        const auto scene = readSceneFile(file); // building reports a damaged one
        return scene ? firstMissingIn(*scene) : std::nullopt;
    }
    for (const auto& part : keyMap.parts)
        if (auto missing = firstMissing(part.keyMap, objects))
            return missing;
    if (keyMap.kind == KeyMapKind::kit)
        return std::nullopt;
    // Only the lowest key must have an object of its own.
    const auto name = keyMap.objectFor(keyMap.lowestNote);
    const bool isThere = isGiven(name, objects) || factoryObject(name) || isFile(name);
    return isThere ? std::nullopt : std::optional(shown(name));
}

KeyMap standInFor(const KeyMap& keyMap) {
    return {.kind = KeyMapKind::scaled,
            .lowestNote = keyMap.lowestNote,
            .highestNote = keyMap.highestNote,
            .object = "ring"};
}

std::shared_ptr<const MissingObjects> replaceMissing(Preset& preset,
                                                     const std::vector<EmbeddedObject>& objects) {
    auto first = firstInNetwork(preset.keyMap, objects);
    if (!first)
        first = firstMissing(preset.keyMap, objects);
    if (!first)
        return nullptr;
    MissingObjects missing{.first = std::move(*first),
                           .keyMap = preset.keyMap,
                           .mutedModes = std::exchange(preset.mutedModes, {}),
                           .objects = {}};
    for (const auto& object : objects) {
        const bool isPacked = object.packed != nullptr; // states need only the packed text
        missing.objects.push_back({.name = object.name,
                                   .modal = isPacked ? std::vector<std::byte>() : object.modal,
                                   .packed = object.packed});
    }
    preset.keyMap = standInFor(preset.keyMap);
    return std::make_shared<const MissingObjects>(std::move(missing));
}

} // namespace idiophone
