// SPDX-License-Identifier: Apache-2.0
// C++ exceptions in WebAssembly. clang compiles `throw` and `catch` to instructions, but Debian's
// C++ library for wasm32-wasi lacks the functions that they call. These are the parts of the
// Itanium C++ ABI that Idiophone needs: there is one thread, no pointer is thrown, and no exception
// is kept for later (std::exception_ptr).
// https://itanium-cxx-abi.github.io/cxx-abi/abi-eh.html
// https://github.com/WebAssembly/tool-conventions/blob/main/EHScheme.md
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>
#include <typeinfo>

namespace __cxxabiv1 {

/// The C++ library's own base of all type information. The order of its virtual functions is fixed.
class __shim_type_info : public std::type_info {
public:
    ~__shim_type_info() override;
    virtual void noop1() const;
    virtual void noop2() const;
    /// Returns whether a handler of this type catches `thrown`, and moves `object` to its base.
    virtual bool can_catch(const __shim_type_info* thrown, void*& object) const = 0;
};

} // namespace __cxxabiv1

namespace {

using __cxxabiv1::__shim_type_info;

/// Stands before each thrown object.
struct alignas(std::max_align_t) Header {
    const __shim_type_info* type;
    void* (*destroy)(void*); ///< a destructor returns its argument in WebAssembly
    void* caught;            ///< the object as its handler sees it
    Header* outer;           ///< the exception whose handler runs around this one
    bool isThrownAgain;      ///< its handler has rethrown it, and must not destroy it
};

Header* innermost = nullptr; ///< whose handler runs

Header& headerOf(void* thrown) {
    return static_cast<Header*>(thrown)[-1];
}

/// Reads the tables that clang writes for each function with handlers (LSDA).
class TableReader {
public:
    explicit TableReader(const std::uint8_t* bytes) : next(bytes) {}

    const std::uint8_t* place() const { return next; }
    std::uint8_t byte() { return *next++; }

    std::uint32_t natural() {
        std::uint32_t value = 0;
        for (unsigned shift = 0;; shift += 7) {
            const auto part = byte();
            value |= std::uint32_t{part & 0x7fU} << shift;
            if ((part & 0x80) == 0)
                return value;
        }
    }

    std::int32_t integer() {
        std::uint32_t value = 0;
        for (unsigned shift = 0;;) {
            const auto part = byte();
            value |= std::uint32_t{part & 0x7fU} << shift;
            shift += 7;
            if ((part & 0x80) != 0)
                continue;
            if ((part & 0x40) != 0 && shift < 32)
                value |= ~std::uint32_t{0} << shift;
            return static_cast<std::int32_t>(value);
        }
    }

private:
    const std::uint8_t* next;
};

/// Returns the number of the first handler of a landing pad that catches the exception, as the
/// table counts them, or 0: only destructors run there.
std::int32_t handlerFor(Header& header, void* thrown, const std::uint8_t* table, unsigned pad) {
    constexpr std::uint8_t omitted = 0xff;
    TableReader reader(table);
    if (reader.byte() != omitted)
        std::abort();                    // clang never writes a base of landing pads here
    const std::uint8_t* types = nullptr; // of handlers, ending here
    if (reader.byte() != omitted) {
        const auto length = reader.natural();
        types = reader.place() + length;
    }
    reader.byte(); // the encoding of what follows, which is always the same
    const auto length = reader.natural();
    const auto* const actions = reader.place() + length;
    for (; pad > 0; --pad) {
        reader.natural();
        reader.natural();
    }
    reader.natural();
    const auto first = reader.natural();
    if (first == 0)
        return 0;
    for (TableReader action(actions + first - 1);;) {
        const auto handler = action.integer();
        const auto* const before = action.place();
        const auto step = action.integer();
        if (handler > 0) {
            const __shim_type_info* type = nullptr;
            std::memcpy(&type, types - handler * sizeof type, sizeof type);
            header.caught = thrown;
            if (type == nullptr || type->can_catch(header.type, header.caught))
                return handler;
        }
        if (step == 0)
            return 0;
        action = TableReader(before + step);
    }
}

} // namespace

extern "C" {

/// clang's code sets the landing pad and its table, and reads the handler.
thread_local struct {
    std::uintptr_t pad;
    const std::uint8_t* table;
    std::uintptr_t handler;
} __wasm_lpad_context;

int _Unwind_CallPersonality(void* thrown) {
    auto& header = headerOf(thrown);
    __wasm_lpad_context.handler =
        handlerFor(header, thrown, __wasm_lpad_context.table, __wasm_lpad_context.pad);
    return 0;
}

void* __cxa_allocate_exception(std::size_t bytes) noexcept {
    auto* const header = static_cast<Header*>(std::malloc(sizeof(Header) + bytes));
    if (header == nullptr)
        std::terminate();
    *header = {};
    return header + 1;
}

void __cxa_free_exception(void* thrown) noexcept {
    std::free(&headerOf(thrown));
}

[[noreturn]] void __cxa_throw(void* thrown, const std::type_info* type, void* (*destroy)(void*)) {
    auto& header = headerOf(thrown);
    header.type = static_cast<const __shim_type_info*>(type);
    header.destroy = destroy;
    __builtin_wasm_throw(0, thrown);
}

[[noreturn]] void __cxa_rethrow() {
    innermost->isThrownAgain = true;
    __builtin_wasm_throw(0, innermost + 1);
}

void* __cxa_begin_catch(void* thrown) noexcept {
    auto& header = headerOf(thrown);
    header.outer = innermost;
    header.isThrownAgain = false;
    innermost = &header;
    return header.caught;
}

void __cxa_end_catch() {
    auto* const header = innermost;
    innermost = header->outer;
    if (header->isThrownAgain)
        return;
    if (header->destroy != nullptr)
        header->destroy(header + 1);
    std::free(header);
}

} // extern "C"

// These throw; the operators of the C++ library return null instead.

void* operator new(std::size_t bytes) {
    if (void* const memory = std::malloc(bytes == 0 ? 1 : bytes))
        return memory;
    throw std::bad_alloc();
}

void* operator new(std::size_t bytes, std::align_val_t alignment) {
    const auto unit = static_cast<std::size_t>(alignment);
    if (bytes <= SIZE_MAX - unit)
        if (void* const memory = std::aligned_alloc(unit, (bytes + unit - 1) / unit * unit))
            return memory;
    throw std::bad_alloc();
}
