# SPDX-License-Identifier: MIT
# Every third-party package of the compiler, looked for together so that one message names all that are
# missing. The loader needs none of them. Which room may use which: tests/guard/floors.py.
set(posepack_missing "")

# Each line: the package as CMake knows it, and Debian's name for it.
macro(posepack_want_package name debian_package)
    find_package(${name} CONFIG QUIET)
    if(NOT ${name}_FOUND)
        list(APPEND posepack_missing "${name} (${debian_package})")
    endif()
endmacro()

# A library of which only headers are used: the variable holds their folder.
macro(posepack_want_header variable header debian_package)
    find_path(${variable} ${header})
    mark_as_advanced(${variable})
    if(NOT ${variable})
        list(APPEND posepack_missing "${header} (${debian_package})")
    endif()
endmacro()

find_package(Threads REQUIRED)
posepack_want_package(fmt libfmt-dev)
posepack_want_package(glm libglm-dev)
posepack_want_package(CLI11 libcli11-dev)
posepack_want_package(nlohmann_json nlohmann-json3-dev)
posepack_want_package(draco libdraco-dev)
posepack_want_package(meshoptimizer libmeshoptimizer-dev)
# Debian's Imath remarks that its Python library, which nobody here wants, is not installed.
set(posepack_log_level "${CMAKE_MESSAGE_LOG_LEVEL}")
set(CMAKE_MESSAGE_LOG_LEVEL WARNING)
posepack_want_package(OpenEXR libopenexr-dev)
set(CMAKE_MESSAGE_LOG_LEVEL "${posepack_log_level}")

# tinygltf is compiled into src/animal with its RapidJSON backend, 2.5 times as fast as Debian's library
# (docs/design/0001-libraries.md); only headers are needed.
posepack_want_header(POSEPACK_TINYGLTF_INCLUDE tiny_gltf.h libtinygltf-dev)
posepack_want_header(POSEPACK_RAPIDJSON_INCLUDE rapidjson/reader.h rapidjson-dev)

find_package(PkgConfig QUIET)
if(PkgConfig_FOUND)
    pkg_check_modules(nettle QUIET IMPORTED_TARGET nettle)
endif()
if(NOT TARGET PkgConfig::nettle)
    list(APPEND posepack_missing "nettle (pkg-config and nettle-dev)")
endif()

if(posepack_missing)
    list(JOIN posepack_missing "\n    " posepack_missing)
    message(FATAL_ERROR "The compiler of posepack needs packages that were not found. ./dev build installs them "
                        "on Debian; -DPOSEPACK_BUILD_COMPILER=OFF builds the loader without them.\n    ${posepack_missing}")
endif()
