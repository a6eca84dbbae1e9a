// SPDX-License-Identifier: Apache-2.0
// Reads objects from memory, in the formats that the build has.
#pragma once

#include "Object/ModalObject.h"

#include <cstddef>
#include <span>
#include <string_view>

namespace idiophone::c {

/// `name` stands for the file in the error, which is one sentence.
Result<ModalObject> objectOfBytes(std::span<const std::byte> bytes, std::string_view name);

} // namespace idiophone::c
