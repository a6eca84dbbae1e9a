// Modal objects by name, each loaded once and shared read-only in the process: factory objects from
// the program itself, others from files.
#pragma once

#include "Instrument/ObjectSource.h"

#include <map>
#include <mutex>
#include <string>

namespace idiophone {

/// Thread-safe; it locks and reads files, so never on the audio thread. Reading a file does not
/// block other threads. Threads that read the same file at the same time all get the first one's
/// object.
class ObjectLibrary final : public ObjectSource {
public:
    ObjectLibrary() = default;
    /// Makes a library that asks `others`, which must outlive it, for names not added to this
    /// library. A build uses it for names that only that build knows.
    explicit ObjectLibrary(ObjectLibrary& others) : behind(&others) {}

    /// Returns the library that all plugin instances in this process share. Never add to it,
    /// because a name must mean the same object to all of them.
    static ObjectLibrary& shared();

    bool has(const std::string& name) override;

    /// Returns a factory object ("xylophone-72"), or the modal object file at that path in UTF-8.
    Result<std::shared_ptr<const ModalObject>> find(const std::string& name) override;

    /// Adds an object under a name, for example one embedded in a saved state. It has precedence
    /// over the factory and files while the returned pointer is held.
    std::shared_ptr<const ModalObject> add(const std::string& name, ModalObject object);
    /// Adds an object that is shared already and not null.
    void add(const std::string& name, const std::shared_ptr<const ModalObject>& object);

private:
    std::shared_ptr<const ModalObject> known(const std::string& key); ///< null if unknown
    std::shared_ptr<const ModalObject> knownUnderLock(const std::string& key) const;
    void keepUnderLock(const std::string& key, const std::shared_ptr<const ModalObject>& object);

    ObjectLibrary* const behind = nullptr;
    std::mutex mutex;
    std::map<std::string, std::weak_ptr<const ModalObject>>
        loaded; ///< objects that somebody still holds
};

} // namespace idiophone
