// SPDX-License-Identifier: Apache-2.0
#include "Object/Safetensors.h"

#include "Object/OneLine.h"
#include "Object/UntrustedJson.h"

#include <algorithm>

namespace idiophone::safetensors {
namespace {

using nlohmann::json;

constexpr std::size_t headerLimitBytes = 1 << 20;

std::size_t valueBytes(const std::string& type) {
    static const std::map<std::string, std::size_t> sizes{
        {"F64", 8},  {"I64", 8}, {"U64", 8}, {"F32", 4}, {"I32", 4}, {"U32", 4}, {"F16", 2},
        {"BF16", 2}, {"I16", 2}, {"U16", 2}, {"I8", 1},  {"U8", 1},  {"BOOL", 1}};
    const auto found = sizes.find(type);
    if (found == sizes.end())
        throw Fault{"its header names an unknown number type " + inQuotes(type)};
    return found->second;
}

Tensor parseTensor(const std::string& name, const json& entry, std::span<const std::byte> data) {
    const auto fault = [&](const char* what) {
        return Fault{"tensor " + inQuotes(name) + " " + what};
    };
    if (!entry.is_object() || !entry.contains("dtype") || !entry["dtype"].is_string() ||
        !entry.contains("shape") || !entry["shape"].is_array() || !entry.contains("data_offsets") ||
        !entry["data_offsets"].is_array() || entry["data_offsets"].size() != 2)
        throw fault("is not described by dtype, shape and data_offsets");

    Tensor tensor{.type = entry["dtype"], .shape = {}, .bytes = {}};
    std::uint64_t size = valueBytes(tensor.type);
    for (const auto& dimension : entry["shape"]) {
        if (!dimension.is_number_unsigned())
            throw fault("has a size that is not a whole positive number");
        const auto count = dimension.get<std::uint64_t>();
        // Divide instead of multiplying, so that a hostile size cannot wrap around.
        if (count != 0 && size > data.size() / count)
            throw fault("claims more data than the file holds");
        tensor.shape.push_back(count);
        size *= count;
    }
    const auto& offsets = entry["data_offsets"];
    if (!offsets[0].is_number_unsigned() || !offsets[1].is_number_unsigned())
        throw fault("has an offset that is not a whole positive number");
    const auto begin = offsets[0].get<std::uint64_t>();
    const auto end = offsets[1].get<std::uint64_t>();
    if (begin > end || end > data.size())
        throw fault("lies outside the file");
    if (end - begin != size)
        throw fault("has a length that does not match its shape");
    tensor.bytes = data.subspan(begin, size);
    return tensor;
}

void requireContiguous(std::vector<std::span<const std::byte>> parts,
                       std::span<const std::byte> data) {
    std::ranges::sort(parts, {}, [](const auto& part) {
        return std::pair(part.data(), part.size()); // empty tensors before their neighbour
    });
    const auto* next = data.data();
    for (const auto& part : parts) {
        if (part.data() < next)
            throw Fault{"two of its tensors overlap"};
        if (part.data() > next)
            throw Fault{"there is a gap between its tensors"};
        next = part.data() + part.size();
    }
    if (next != data.data() + data.size())
        throw Fault{"it goes on after its last tensor"};
}

/// Expects a file of at least eight bytes.
std::uint64_t headerLengthOf(std::span<const std::byte> bytes) {
    std::uint64_t length = 0;
    std::memcpy(&length, bytes.data(), sizeof length);
    return length;
}

} // namespace

bool hasReadableHeader(std::span<const std::byte> bytes) {
    return bytes.size() >= sizeof(std::uint64_t) && headerLengthOf(bytes) <= headerLimitBytes;
}

Container parse(std::span<const std::byte> bytes) {
    if (bytes.size() < sizeof(std::uint64_t))
        throw Fault{"it is too short to be a modal object"};
    const auto headerLength = headerLengthOf(bytes);
    bytes = bytes.subspan(sizeof(std::uint64_t));
    if (headerLength > headerLimitBytes)
        throw Fault{"it is not a modal object"};
    if (headerLength > bytes.size())
        throw Fault{"it is cut off inside its header"};

    const json header = parseUntrusted(
        {reinterpret_cast<const char*>(bytes.data()), static_cast<std::size_t>(headerLength)});
    if (!header.is_object())
        throw Fault{"its header is not a JSON object"};

    const auto data = bytes.subspan(headerLength);
    Container container;
    std::vector<std::span<const std::byte>> parts;
    for (const auto& [name, entry] : header.items()) {
        if (name == "__metadata__") {
            container.metadata = entry;
            continue;
        }
        const auto& tensor =
            container.tensors.emplace(name, parseTensor(name, entry, data)).first->second;
        parts.push_back(tensor.bytes);
    }
    requireContiguous(std::move(parts), data);
    return container;
}

Writer::Writer(json metadata) {
    header["__metadata__"] = std::move(metadata);
}

void Writer::addBytes(const char* name,
                      const char* type,
                      const std::vector<std::size_t>& shape,
                      std::span<const std::byte> bytes) {
    const auto begin = data.size();
    data.insert(data.end(), bytes.begin(), bytes.end());
    header[name] = {{"dtype", type}, {"shape", shape}, {"data_offsets", {begin, data.size()}}};
}

std::vector<std::byte> Writer::finish() const {
    // Names come from people and files: replace invalid UTF-8 instead of throwing.
    auto text = header.dump(-1, ' ', false, json::error_handler_t::replace);
    text.resize((text.size() + 7) / 8 * 8, ' '); // aligns the tensors, as safetensors asks
    const std::uint64_t length = text.size();
    std::vector<std::byte> file(sizeof length + text.size());
    std::memcpy(file.data(), &length, sizeof length);
    std::memcpy(file.data() + sizeof length, text.data(), text.size());
    file.insert(file.end(), data.begin(), data.end());
    return file;
}

} // namespace idiophone::safetensors
