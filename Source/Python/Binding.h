// Errors, progress and the interpreter's lock, for all Python bindings.
#pragma once

#include "Object/ModalObject.h"
#include "Object/WorkControl.h"

#include <Eigen/Core>
#include <atomic>
#include <memory>
#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <optional>
#include <string>
#include <utility>

namespace idiophone::python {

namespace nb = nanobind;

using Numbers3 = std::array<double, 3>;
using Array3 = nb::ndarray<const double, nb::shape<-1, 3>, nb::c_contig, nb::device::cpu>;

/// A modal object as Python holds it: arrays are views into it.
struct PythonObject {
    std::shared_ptr<const ModalObject> object;
};

/// Returns the value, or raises ValueError with the sentence.
template <class Value>
Value valueOf(Result<Value>&& result) {
    if (!result)
        throw nb::value_error(result.error().message.c_str());
    return std::move(*result);
}

/// Runs `work(control)` without the interpreter's lock. `progress(fraction, step)` may be None; an
/// exception in it, and KeyboardInterrupt, end the work.
template <class Work>
auto worked(const nb::object& progress, Work work) {
    std::atomic<bool> cancelled{false};
    std::optional<nb::python_error> raised;
    const WorkControl control{.progress =
                                  [&](double fraction, std::string_view step) {
                                      const nb::gil_scoped_acquire lock;
                                      try {
                                          if (raised)
                                              return;
                                          if (PyErr_CheckSignals() != 0)
                                              nb::raise_python_error();
                                          if (!progress.is_none())
                                              progress(fraction, std::string(step));
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
