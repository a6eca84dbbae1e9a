// Arrays, errors, progress and the interpreter's lock, for all Python bindings.
#pragma once

#include "Object/ModalObject.h"
#include "Object/WorkControl.h"

#include <array>
#include <atomic>
#include <memory>
#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <optional>
#include <string>
#include <utility>

namespace idiophone::python {

namespace nb = nanobind;

/// N numbers, from a sequence or an array; nothing if something else was given.
template <std::size_t N>
struct Numbers : std::optional<std::array<double, N>> {};
using Numbers3 = Numbers<3>;

/// Returns the numbers. `name` stands for them in the ValueError that it raises without them.
template <std::size_t N>
const std::array<double, N>& valuesOf(const Numbers<N>& numbers, const std::string& name) {
    if (!numbers)
        throw nb::value_error((name + " is not " + std::to_string(N) + " numbers").c_str());
    return *numbers;
}

/// Anything from which NumPy makes an array.
class ArrayLike : public nb::object {
    NB_OBJECT(ArrayLike, nb::object, "numpy.typing.ArrayLike", [](PyObject*) { return true; })
};

/// Returns the contiguous array of a type that NumPy makes of what is given. Raises ValueError with
/// the fault if it has another number of dimensions or columns.
template <class Array>
Array arrayOf(const ArrayLike& given, const char* type, const std::string& fault) {
    Array array;
    if (!nb::try_cast(nb::module_::import_("numpy").attr("ascontiguousarray")(given, type), array))
        throw nb::value_error(fault.c_str());
    return array;
}

/// progress(fraction, step)
using Progress = std::optional<nb::typed<nb::callable, nb::object(double, std::string)>>;

/// A modal object as Python holds it: arrays are views into it.
struct PythonObject {
    std::shared_ptr<const ModalObject> object;
};

inline PythonObject held(ModalObject&& object) {
    return {std::make_shared<const ModalObject>(std::move(object))};
}

/// Returns the value, or raises ValueError with the sentence.
template <class Value>
Value valueOf(Result<Value>&& result) {
    if (!result)
        throw nb::value_error(result.error().message.c_str());
    return std::move(*result);
}

/// Returns the library's or the user's material. Raises ValueError if there is none.
Material materialNamed(const std::string& name);

/// Raises KeyboardInterrupt if it is due. Needs the interpreter's lock.
inline void checkInterrupt() {
    if (PyErr_CheckSignals() != 0)
        nb::raise_python_error();
}

/// Runs `work(control)` without the interpreter's lock. An exception in `progress`, and
/// KeyboardInterrupt, end the work.
template <class Work>
auto worked(const Progress& progress, Work work) {
    std::atomic<bool> cancelled{false};
    std::optional<nb::python_error> raised;
    const WorkControl control{.progress =
                                  [&](double fraction, std::string_view step) {
                                      const nb::gil_scoped_acquire lock;
                                      try {
                                          if (raised)
                                              return;
                                          checkInterrupt();
                                          if (progress)
                                              (*progress)(fraction, std::string(step));
                                      } catch (nb::python_error& error) {
                                          raised.emplace(std::move(error));
                                          cancelled = true;
                                      }
                                  },
                              .cancelled = &cancelled};
    auto result = [&] {
        const nb::gil_scoped_release unlocked;
        return work(control);
    }();
    if (raised)
        throw std::move(*raised);
    return valueOf(std::move(result));
}

void bindMaterials(nb::module_& module);
void bindMeshes(nb::module_& module);
void bindObjects(nb::module_& module);
void bindAnalysis(nb::module_& module);
void bindWorlds(nb::module_& module);

} // namespace idiophone::python

namespace nanobind::detail {

template <std::size_t N>
struct type_caster<idiophone::python::Numbers<N>> {
    using Array = std::array<double, N>;
    NB_TYPE_CASTER(idiophone::python::Numbers<N>, const_name("numpy.typing.ArrayLike"))

    bool from_python(handle source, std::uint8_t flags, cleanup_list* cleanup) noexcept {
        make_caster<Array> array;
        value = {};
        if (array.from_python(source, flags, cleanup))
            value.emplace(array.value);
        return true;
    }
    static handle from_cpp(const idiophone::python::Numbers<N>& numbers,
                           rv_policy policy,
                           cleanup_list* cleanup) noexcept {
        return make_caster<Array>::from_cpp(*numbers, policy, cleanup);
    }
};

} // namespace nanobind::detail
