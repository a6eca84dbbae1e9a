#include "Instrument/ModeSet.h"

namespace idiophone {

bool ModeSet::set(const std::string& object, std::int32_t mode, bool isIn) {
    if (!isIn) {
        if (const auto found = modes.find(object); found != modes.end()) {
            count -= found->second.erase(mode);
            if (found->second.empty())
                modes.erase(found);
        }
        return true;
    }
    if (contains(object, mode))
        return true;
    if (mode < 0 || mode >= maximumModes || size() >= capacity)
        return false;
    modes[object].insert(mode);
    ++count;
    return true;
}

bool ModeSet::contains(const std::string& object, std::int32_t mode) const {
    return of(object).contains(mode);
}

void ModeSet::clear(const std::string& object) {
    count -= of(object).size();
    modes.erase(object);
}

const std::set<std::int32_t>& ModeSet::of(const std::string& object) const {
    static const std::set<std::int32_t> none;
    const auto found = modes.find(object);
    return found == modes.end() ? none : found->second;
}

} // namespace idiophone
