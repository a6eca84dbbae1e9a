#include "Instrument/ObjectLibrary.h"

#include "Gltf/ObjectFile.h"
#include "Instrument/FactoryContent.h"
#include "Object/FileBytes.h"
#include "Object/ModalObjectFile.h"

#include <cstdint>
#include <filesystem>

namespace idiophone {
namespace {

/// Returns the key of a file's object. It includes the time of the last change, because a changed
/// file is another object. libc++ counts it in 128 bits, which std::to_string does not take.
std::string fileKey(const std::filesystem::path& file) {
    std::error_code fault;
    const auto path = std::filesystem::weakly_canonical(file, fault);
    const auto written = std::filesystem::last_write_time(path, fault);
    const auto ticks = static_cast<std::int64_t>(written.time_since_epoch().count());
    return nameOf(path) + "@" + std::to_string(ticks);
}

} // namespace

ObjectLibrary& ObjectLibrary::shared() {
    static ObjectLibrary library;
    return library;
}

bool ObjectLibrary::has(const std::string& name) {
    if (known(name))
        return true;
    if (behind != nullptr)
        return behind->has(name);
    std::error_code fault;
    return factoryObject(name) ||
           (!name.empty() && std::filesystem::exists(pathNamed(name), fault));
}

Result<std::shared_ptr<const ModalObject>> ObjectLibrary::find(const std::string& name) {
    if (auto object = known(name))
        return object;
    if (behind != nullptr)
        return behind->find(name);
    if (name.empty())
        return failure("no object is named");
    const auto factory = factoryObject(name);
    const auto key = factory ? name : fileKey(pathNamed(name));
    if (auto object = known(key))
        return object;

    // Read without the lock: a large file takes seconds, and other threads must not wait for it.
    auto object = factory ? readModalObject(*factory, name) : readObject(pathNamed(name));
    if (!object)
        return tl::unexpected(object.error());
    auto read = std::make_shared<const ModalObject>(std::move(*object));
    const std::scoped_lock lock(mutex);
    if (auto meanwhile = knownUnderLock(key))
        return meanwhile;
    keepUnderLock(key, read);
    return read;
}

std::shared_ptr<const ModalObject> ObjectLibrary::known(const std::string& key) {
    const std::scoped_lock lock(mutex);
    return knownUnderLock(key);
}

std::shared_ptr<const ModalObject> ObjectLibrary::knownUnderLock(const std::string& key) const {
    const auto found = loaded.find(key);
    return found == loaded.end() ? nullptr : found->second.lock();
}

void ObjectLibrary::keepUnderLock(const std::string& key,
                                  const std::shared_ptr<const ModalObject>& object) {
    std::erase_if(loaded, [](const auto& entry) { return entry.second.expired(); });
    loaded[key] = object;
}

std::shared_ptr<const ModalObject> ObjectLibrary::add(const std::string& name, ModalObject object) {
    auto kept = std::make_shared<const ModalObject>(std::move(object));
    add(name, kept);
    return kept;
}

void ObjectLibrary::add(const std::string& name, const std::shared_ptr<const ModalObject>& object) {
    const std::scoped_lock lock(mutex);
    keepUnderLock(name, object);
}

} // namespace idiophone
