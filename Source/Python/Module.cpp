#include "Python/Binding.h"

NB_MODULE(_core, module) {
    using namespace idiophone::python;
    bindMaterials(module);
    bindMeshes(module);
    bindObjects(module);
    bindAnalysis(module);
    bindWorlds(module);
}
