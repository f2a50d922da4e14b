// SPDX-License-Identifier: MIT
// The one translation unit that holds tinygltf's body.
#define TINYGLTF_IMPLEMENTATION
#include "animal/tinygltf.hpp"
