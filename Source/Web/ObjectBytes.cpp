// SPDX-License-Identifier: Apache-2.0
#include "C/ObjectBytes.h"

#include "Object/ModalObjectBytes.h"

idiophone::Result<idiophone::ModalObject>
idiophone::c::objectOfBytes(std::span<const std::byte> bytes, std::string_view name) {
    return readModalObject(bytes, name);
}
