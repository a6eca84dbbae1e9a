// Modal objects by name, each loaded once and shared read-only by everybody in the process: the
// factory's from the program itself, others from files.
#pragma once

#include "Object/ModalObject.h"

#include <map>
#include <memory>
#include <mutex>
#include <string>

namespace idiophone {

/// Thread-safe; it locks and reads files, so never on the audio thread. While a file is read others
/// are not kept waiting; of threads that read the same one at a time, all get what the first has
/// read.
class ObjectLibrary {
public:
    ObjectLibrary() = default;
    /// One that asks the other, which outlives it, for what was not added to it: names that mean
    /// something of their own for one build, and to nobody else.
    explicit ObjectLibrary(ObjectLibrary& others) : behind(&others) {}

    /// The library shared by every instance of the plugin in this process. Nothing is added to it,
    /// as a name has to mean the same object to all of them.
    static ObjectLibrary& shared();

    /// Whether `find` has something to return or to read under that name.
    bool has(const std::string& name);

    /// A factory object ("xylophone-72"), or else the modal object file of that path in UTF-8.
    Result<std::shared_ptr<const ModalObject>> find(const std::string& name);

    /// Makes an object known under a name, as one embedded in a saved state; it wins over the
    /// factory and files for as long as somebody holds the pointer that is returned.
    std::shared_ptr<const ModalObject> add(const std::string& name, ModalObject object);
    /// The same with one that is shared already; it is not null.
    void add(const std::string& name, const std::shared_ptr<const ModalObject>& object);

private:
    std::shared_ptr<const ModalObject> known(const std::string& key); ///< or null
    std::shared_ptr<const ModalObject> knownUnderLock(const std::string& key) const;
    void keepUnderLock(const std::string& key, const std::shared_ptr<const ModalObject>& object);

    ObjectLibrary* const behind = nullptr;
    std::mutex mutex;
    std::map<std::string, std::weak_ptr<const ModalObject>> loaded; ///< what somebody holds
};

} // namespace idiophone
