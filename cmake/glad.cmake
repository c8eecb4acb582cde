# SPDX-License-Identifier: MIT
# The OpenGL 4.5 core loader, generated at build time from the specification that the generator carries.
find_program(GLAD_GENERATOR glad REQUIRED)
set(GLAD_FOLDER ${CMAKE_BINARY_DIR}/glad)
add_custom_command(
    OUTPUT ${GLAD_FOLDER}/include/glad/gl.h
    COMMAND ${GLAD_GENERATOR} --api gl:core=4.5 --extensions GL_KHR_debug --out-path ${GLAD_FOLDER} --quiet --reproducible
            c --header-only
    COMMENT "Generating the OpenGL loader"
    VERBATIM)
add_custom_target(glad_generated DEPENDS ${GLAD_FOLDER}/include/glad/gl.h)
add_library(glad INTERFACE)
add_dependencies(glad glad_generated)
# Installed, it lies beside our headers.
target_include_directories(glad SYSTEM INTERFACE $<BUILD_INTERFACE:${GLAD_FOLDER}/include>)
