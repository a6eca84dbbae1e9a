// The safetensors container: named tensors behind a JSON header. Knows nothing of modal objects.
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

/// What is wrong with a file; thrown while parsing and turned into a Result at the room's boundary.
struct Fault {
    std::string sentence;
};

/// A view of one tensor in the bytes that were parsed.
struct Tensor {
    std::string type;                 ///< "F64", "I32", ...
    std::vector<std::uint64_t> shape; ///< its product times the type's size is bytes.size()
    std::span<const std::byte> bytes;

    /// The values, which must be of the type that the caller has checked.
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

/// Checks every length and offset: tensors lie inside the file and cover it without gap or overlap.
/// The container's tensors point into `bytes`. Throws Fault.
Container parse(std::span<const std::byte> bytes);

/// Whether `parse` takes a header of this file's length: it is at most 1 MiB.
bool hasReadableHeader(std::span<const std::byte> bytes);

/// Builds a file tensor by tensor; the same calls give the same bytes.
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
