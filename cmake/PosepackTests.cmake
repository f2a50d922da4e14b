# SPDX-License-Identifier: MIT
# What tests are made of. Labels: unit, guard; other folders of tests/ name their own.
include(GoogleTest)
find_package(GTest CONFIG REQUIRED)
find_package(Python3 3.9 COMPONENTS Interpreter REQUIRED)

# posepack_add_unit_test(NAME SOURCES file... LIBRARIES target...): a GoogleTest executable, one ctest test.
function(posepack_add_unit_test name)
    cmake_parse_arguments(arg "" "" "SOURCES;LIBRARIES" ${ARGN})
    add_executable(${name} ${arg_SOURCES})
    target_link_libraries(${name} PRIVATE posepack_cxx_flags ${arg_LIBRARIES} GTest::gtest_main)
    target_compile_options(${name} PRIVATE $<$<CONFIG:Release>:-O1>)  # built often, run once
    add_test(NAME ${name} COMMAND ${name})
    set_tests_properties(${name} PROPERTIES LABELS unit)
endfunction()

# posepack_add_guard(NAME [argument...]): runs NAME.py of the current folder with Python, given the root of the
# project and the arguments.
function(posepack_add_guard name)
    add_test(NAME guard_${name}
             COMMAND Python3::Interpreter -B ${CMAKE_CURRENT_SOURCE_DIR}/${name}.py ${PROJECT_SOURCE_DIR} ${ARGN})
    set_tests_properties(guard_${name} PROPERTIES LABELS guard)
endfunction()
