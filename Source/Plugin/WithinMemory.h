// Runs work on files and states, and turns a lack of memory or threads into an error.
#pragma once

#include "Object/Result.h"

#include <new>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

namespace idiophone {

/// Returns the sentence for a subject after a system error, usually a failure to start a thread.
inline std::string sentenceOf(const std::system_error& fault, std::string_view subject) {
    if (fault.code() == std::errc::resource_unavailable_try_again)
        return std::string(subject) + " needs a thread, and this machine starts no more";
    return std::string(subject) + " cannot be made: " + fault.what();
}

/// Returns the Result of `work`. If memory or threads do not suffice, returns a failure that names
/// the subject. Not for the audio thread.
template <class Work>
auto withinMemory(Work&& work, std::string_view subject = "it") -> decltype(work()) {
    try {
        return std::forward<Work>(work)();
    } catch (const std::bad_alloc&) {
        return failure(std::string(subject) + " takes more memory than this machine has");
    } catch (const std::system_error& fault) {
        return failure(sentenceOf(fault, subject));
    }
}

} // namespace idiophone
