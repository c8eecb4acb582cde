# SPDX-License-Identifier: MIT
# A header that needs another include before it is broken: compile one source per header, with nothing else. A test
# does it, for nothing of it is ever run; `ninja headers_alone` does it at once.
file(GLOB_RECURSE headers CONFIGURE_DEPENDS RELATIVE ${CMAKE_SOURCE_DIR}
     ${CMAKE_SOURCE_DIR}/engine/*.h ${CMAKE_SOURCE_DIR}/game/*.h ${CMAKE_SOURCE_DIR}/editor/*.h
     ${CMAKE_SOURCE_DIR}/shader/shared/*.h)
set(alone)
foreach(header ${headers})
    string(MAKE_C_IDENTIFIER ${header} stem)
    set(source ${CMAKE_BINARY_DIR}/headers_alone/${stem}.cpp)
    file(CONFIGURE OUTPUT ${source} CONTENT "#include \"${header}\"\n#include \"${header}\"\n")
    list(APPEND alone ${source})
endforeach()
add_library(headers_alone OBJECT EXCLUDE_FROM_ALL ${alone})
target_link_libraries(headers_alone PRIVATE sl_options sl_commands)
target_compile_options(headers_alone PRIVATE -O0)
add_test(NAME headers_alone COMMAND ${CMAKE_COMMAND} --build ${CMAKE_BINARY_DIR} --target headers_alone)
set_tests_properties(headers_alone PROPERTIES TIMEOUT 1200 PROCESSORS 2 LABELS build)
