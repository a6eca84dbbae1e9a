// What is made of files and states, which may ask for any memory.
#pragma once

#include "Object/Result.h"

#include <new>
#include <string>
#include <string_view>
#include <utility>

namespace idiophone {

/// What `work` returns, a Result, or where the memory does not suffice a failure that says so of
/// the subject. Not for the audio thread.
template <class Work>
auto withinMemory(Work&& work, std::string_view subject = "it") -> decltype(work()) {
    try {
        return std::forward<Work>(work)();
    } catch (const std::bad_alloc&) {
        return failure(std::string(subject) + " takes more memory than this machine has");
    }
}

} // namespace idiophone
