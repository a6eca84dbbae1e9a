// SPDX-License-Identifier: Apache-2.0
#include <fstream>

#define TINYGLTF_IMPLEMENTATION
#include "Gltf/TinyGltf.h"
