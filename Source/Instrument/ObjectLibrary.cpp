#include "Instrument/ObjectLibrary.h"

#include "Instrument/FactoryContent.h"
#include "Object/ModalObjectFile.h"

#include <filesystem>

namespace idiophone {
namespace {

/// What a file's object is kept under: a file that changed is another object.
std::string fileKey(const std::string& name) {
    std::error_code fault;
    const auto path = std::filesystem::weakly_canonical(name, fault);
    const auto written = std::filesystem::last_write_time(path, fault);
    return path.string() + "@" + std::to_string(written.time_since_epoch().count());
}

} // namespace

ObjectLibrary& ObjectLibrary::shared() {
    static ObjectLibrary library;
    return library;
}

Result<std::shared_ptr<const ModalObject>> ObjectLibrary::find(const std::string& name) {
    const std::scoped_lock lock(mutex);
    if (const auto known = loaded[name].lock())
        return known;
    const auto factory = factoryObject(name);
    const auto key = factory ? name : fileKey(name);
    if (const auto known = loaded[key].lock())
        return known;

    auto object = factory ? readModalObject(*factory, name) : readModalObject(name);
    if (!object)
        return tl::unexpected(object.error());
    auto kept = std::make_shared<const ModalObject>(std::move(*object));
    loaded[key] = kept;
    return kept;
}

std::shared_ptr<const ModalObject> ObjectLibrary::add(const std::string& name, ModalObject object) {
    auto kept = std::make_shared<const ModalObject>(std::move(object));
    add(name, kept);
    return kept;
}

void ObjectLibrary::add(const std::string& name, const std::shared_ptr<const ModalObject>& object) {
    const std::scoped_lock lock(mutex);
    loaded[name] = object;
}

} // namespace idiophone
