// SPDX-License-Identifier: Apache-2.0
// Handles, errors, and structures of any version, for all functions of the C interface. No
// exception leaves the interface.
#pragma once

#include "C/idiophone.h"
#include "World/World.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <exception>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>

struct idiophone_object {
    std::shared_ptr<const idiophone::ModalObject> object;
};

struct idiophone_world {
    std::unique_ptr<idiophone::World> world;
};

namespace idiophone::c {

/// Returns the sentence of `idiophone_error`, one for each thread.
inline std::string& lastError() {
    thread_local std::string text;
    return text;
}

/// Returns what `make` returns, or null with an error.
template <class Make>
typename std::invoke_result_t<Make>::value_type orNull(Make make) noexcept {
    std::string text;
    try {
        auto made = make();
        if (made)
            return *made;
        text = std::move(made.error().message);
    } catch (const std::exception& fault) {
        text = fault.what();
    }
    std::swap(lastError(), text);
    return nullptr;
}

inline idiophone_object* handleOf(ModalObject&& object) {
    return new idiophone_object{std::make_shared<const ModalObject>(std::move(object))};
}

/// Returns a structure of any version. Fields that the program does not know have their defaults.
template <class Structure>
Structure read(const Structure* given, Structure defaults) {
    if (given != nullptr)
        std::memcpy(&defaults, given, std::min<std::size_t>(given->struct_size, sizeof defaults));
    return defaults;
}

} // namespace idiophone::c
