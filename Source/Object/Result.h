// SPDX-License-Identifier: Apache-2.0
// Results that are a value or an error. An error is one sentence for the user that names the file
// or thing at fault. The window and the console show it unchanged.
#pragma once

#include <string>
#include <tl/expected.hpp>

namespace idiophone {

struct Error {
    std::string message;
};

template <class T>
using Result = tl::expected<T, Error>;

inline tl::unexpected<Error> failure(std::string message) {
    return tl::unexpected<Error>(Error{std::move(message)});
}

} // namespace idiophone
