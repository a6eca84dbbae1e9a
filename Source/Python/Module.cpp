#include "Python/Binding.h"

#include <exception>
#include <new>

NB_MODULE(_core, module) {
    using namespace idiophone::python;
    nb::register_exception_translator([](const std::exception_ptr& thrown, void*) {
        try {
            std::rethrow_exception(thrown);
        } catch (const std::bad_alloc&) {
            PyErr_SetString(PyExc_MemoryError, "there is not enough memory");
        }
    });
    module.attr("version") = IDIOPHONE_VERSION; // Debian's package has no metadata of Python's
    bindMaterials(module);
    bindMeshes(module);
    bindObjects(module);
    bindAnalysis(module);
    bindWorlds(module);
}
