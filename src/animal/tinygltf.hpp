// SPDX-License-Identifier: MIT
// The only door to tinygltf: its header with the settings that its implementation is compiled with.
//
// RapidJSON is its JSON backend (2.5 times as fast as Debian's library on our files). Images are never
// decoded, no file is ever opened, and a JSON value of the wrong type throws instead of aborting.
#pragma once

#include <fstream>

#include "animal/rapidjson_settings.hpp"

#define TINYGLTF_USE_RAPIDJSON
// Its pool allocator hangs on one global document: not for several threads.
#define TINYGLTF_USE_RAPIDJSON_CRTALLOCATOR
#define TINYGLTF_NO_INCLUDE_RAPIDJSON
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#define TINYGLTF_NO_FS

#include <rapidjson/document.h>
#include <rapidjson/prettywriter.h>
#include <rapidjson/rapidjson.h>
#include <rapidjson/stringbuffer.h>
#include <rapidjson/writer.h>
#include <tiny_gltf.h>
