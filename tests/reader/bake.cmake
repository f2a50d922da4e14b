# SPDX-License-Identifier: MIT
# Generates the built-in animals and bakes them: cmake -DPOSEPACK= -DFOLDER= -DENCODING= -DCATALOG= -P bake.cmake
file(REMOVE_RECURSE ${FOLDER})
execute_process(COMMAND ${POSEPACK} menagerie ${FOLDER}/models COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${POSEPACK} bake ${CATALOG} --models ${FOLDER}/models -o ${FOLDER}/palettes --no-fsync
                        --encoding ${ENCODING} COMMAND_ERROR_IS_FATAL ANY)
