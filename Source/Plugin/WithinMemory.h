// What is made of files and states, which may ask for any memory, and for threads.
#pragma once

#include "Object/Result.h"

#include <new>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

namespace idiophone {

/// What is said of a subject for which the system does not do what was asked of it: mostly it
/// starts no more threads.
inline std::string sentenceOf(const std::system_error& fault, std::string_view subject) {
    if (fault.code() == std::errc::resource_unavailable_try_again)
        return std::string(subject) + " needs a thread, and this machine starts no more";
    return std::string(subject) + " cannot be made: " + fault.what();
}

/// What `work` returns, a Result, or where memory or threads do not suffice a failure that says so
/// of the subject. Not for the audio thread.
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
