# SPDX-License-Identifier: MIT
# Language levels, warnings, float rules and sanitizers, carried by two interface targets.
set(CMAKE_C_STANDARD 99)
set(CMAKE_C_STANDARD_REQUIRED ON)
set(CMAKE_C_EXTENSIONS OFF)
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
if(PROJECT_IS_TOP_LEVEL AND NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
    set(CMAKE_BUILD_TYPE Release)
endif()

# What both languages share: every room sees src/ ("room/file.hpp") and include/ ("posepack/loader.h").
add_library(posepack_common_flags INTERFACE)
target_include_directories(posepack_common_flags INTERFACE ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR}/include)
target_compile_options(posepack_common_flags INTERFACE -Wall -Wextra -Wpedantic)
# The bytes of a palette must not depend on the compiler's choice to fuse multiplications and additions.
target_compile_options(posepack_common_flags INTERFACE -ffp-contract=off)
if(POSEPACK_WARNINGS_AS_ERRORS)
    target_compile_options(posepack_common_flags INTERFACE -Werror)
endif()
if(POSEPACK_SANITIZE)
    # Every finding ends the program, so that no test passes with one.
    set(sanitizers -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
    target_compile_options(posepack_common_flags INTERFACE ${sanitizers})
    target_link_options(posepack_common_flags INTERFACE ${sanitizers})
endif()
if(POSEPACK_FUZZ)
    # Every file counts its branches for libFuzzer; the targets of tests/fuzz bring the engine.
    target_compile_options(posepack_common_flags INTERFACE -fsanitize=fuzzer-no-link
                           -fsanitize-ignorelist=${PROJECT_SOURCE_DIR}/tests/fuzz/sanitizer_ignore.txt)
endif()

add_library(posepack_c_flags INTERFACE)
target_link_libraries(posepack_c_flags INTERFACE posepack_common_flags)
target_compile_options(posepack_c_flags INTERFACE -Wconversion)

add_library(posepack_cxx_flags INTERFACE)
target_link_libraries(posepack_cxx_flags INTERFACE posepack_common_flags)
# g++ 12 sees overlapping copies in std::string concatenation that are not there. clang lacks the warning.
target_compile_options(posepack_cxx_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)
