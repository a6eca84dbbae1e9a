// SPDX-License-Identifier: Apache-2.0
// The safetensors format: named tensors after a JSON header. Independent of modal objects.
// https://huggingface.co/docs/safetensors: 8-byte little-endian header length, header, raw data.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <map>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

namespace idiophone::safetensors {

static_assert(std::endian::native == std::endian::little, "safetensors are little-endian");

/// An error in a file. Thrown while parsing; the module's public functions turn it into a Result.
struct Fault {
    std::string sentence;
};

/// A view of one tensor in the parsed bytes.
struct Tensor {
    std::string type;                 ///< "F64", "I32", ...
    std::vector<std::uint64_t> shape; ///< its product times the type's size is bytes.size()
    std::span<const std::byte> bytes;

    /// Copies the values. The caller must have checked their type.
    template <class Value>
    std::vector<Value> copy() const {
        std::vector<Value> values(bytes.size() / sizeof(Value));
        if (!values.empty())
            std::memcpy(values.data(), bytes.data(), values.size() * sizeof(Value));
        return values;
    }
};

struct Container {
    nlohmann::json metadata; ///< `__metadata__`, or null
    std::map<std::string, Tensor> tensors;
};

/// Parses a file and checks every length and offset: tensors lie inside the file and cover it
/// without gaps or overlap. The tensors point into `bytes`. Throws Fault.
Container parse(std::span<const std::byte> bytes);

/// Returns whether the header is short enough for `parse`: at most 1 MiB.
bool hasReadableHeader(std::span<const std::byte> bytes);

/// Builds a file tensor by tensor. The same calls give the same bytes.
class Writer {
public:
    /// `metadata` is an object of texts.
    explicit Writer(nlohmann::json metadata);

    template <class Value>
    void add(const char* name,
             const char* type,
             const std::vector<std::size_t>& shape,
             const std::vector<Value>& values) {
        addBytes(name, type, shape, std::as_bytes(std::span(values)));
    }

    std::vector<std::byte> finish() const;

private:
    void addBytes(const char* name,
                  const char* type,
                  const std::vector<std::size_t>& shape,
                  std::span<const std::byte> bytes);

    nlohmann::json header;
    std::vector<std::byte> data;
};

} // namespace idiophone::safetensors
