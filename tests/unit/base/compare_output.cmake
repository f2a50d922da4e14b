# SPDX-License-Identifier: MIT
# Fails unless PROGRAM prints exactly the text of the file PAGE.
execute_process(COMMAND ${PROGRAM} OUTPUT_VARIABLE printed RESULT_VARIABLE result)
if(NOT result EQUAL 0 OR printed STREQUAL "")
    message(FATAL_ERROR "${PROGRAM} printed nothing (exit code ${result})")
endif()
file(READ ${PAGE} page)
if(NOT printed STREQUAL page)
    message(FATAL_ERROR "${PAGE} is out of date: run ${PROGRAM} > ${PAGE}")
endif()
string(LENGTH "${page}" size)
message(STATUS "${PAGE}: ${size} characters compared")
