// Results that are a value or an error. An error is one sentence for the user, which names the file
// or the thing at fault; it is shown as it is, in the window and on the console.
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
