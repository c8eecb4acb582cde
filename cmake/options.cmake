# SPDX-License-Identifier: MIT
# What every source of ours is compiled with, and what programs that use the engine must share with it.
add_library(sl_interface INTERFACE)
target_compile_features(sl_interface INTERFACE cxx_std_20)
target_link_libraries(sl_interface INTERFACE glm::glm fmt::fmt spdlog::spdlog)
target_compile_definitions(sl_interface INTERFACE GLM_FORCE_DEPTH_ZERO_TO_ONE GLM_ENABLE_EXPERIMENTAL)
# shader/ too: shader/shared/*.h are read by C++ and GLSL under one name.
target_include_directories(sl_interface INTERFACE
    $<BUILD_INTERFACE:${CMAKE_SOURCE_DIR}> $<BUILD_INTERFACE:${CMAKE_SOURCE_DIR}/shader>
    $<INSTALL_INTERFACE:${SL_HEADERS}> $<INSTALL_INTERFACE:${SL_DATA}/shader>)

# Warnings and sanitizers are ours alone.
add_library(sl_options INTERFACE)
target_link_libraries(sl_options INTERFACE sl_interface)
# Designated initialisers leave the rest at its default on purpose; g++ 12 sees overlaps in every "a" + std::string(b), and
# clang 19 something deprecated in libstdc++ 12's own std::stable_sort.
target_compile_options(sl_options INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor
                                            -Wno-missing-field-initializers $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
                                            $<$<CXX_COMPILER_ID:Clang>:-Wno-deprecated-declarations>
                                            $<$<BOOL:${SL_WERROR}>:-Werror>)
# Fused multiply-add would make two compilers' pictures differ; the engine's figures must not depend on it.
target_compile_options(sl_options INTERFACE -ffp-contract=off)
if(SL_NATIVE)
    target_compile_options(sl_options INTERFACE -march=native)
endif()
if(SL_SANITIZE)
    # fuzzer-no-link: the code counts which ways it goes, for tests/fuzz; everything else ignores that.
    target_compile_options(sl_options INTERFACE -fsanitize=address,undefined,fuzzer-no-link -fno-omit-frame-pointer
                                                -fno-sanitize-recover=all)
    target_link_options(sl_options INTERFACE -fsanitize=address,undefined)
endif()

# What nearly every source includes is parsed once: it takes longer than most of our own code.
file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/precompiled.cpp CONTENT "")
add_library(sl_headers OBJECT ${CMAKE_BINARY_DIR}/precompiled.cpp)
target_link_libraries(sl_headers PRIVATE sl_options)
target_precompile_headers(sl_headers PRIVATE <fmt/format.h> <fmt/ranges.h> <glm/glm.hpp> <glm/gtc/quaternion.hpp> <spdlog/spdlog.h>
                                             <algorithm> <array> <filesystem> <functional> <map> <memory> <optional> <set>
                                             <span> <string> <unordered_map> <variant> <vector>)

# sl_library(NAME [folders...] LINK libs...): a static library of every .cpp directly in the given folders, main.cpp apart.
function(sl_library name)
    cmake_parse_arguments(ARG "" "" "FOLDERS;LINK" ${ARGN})
    set(sources)
    foreach(folder ${ARG_FOLDERS})
        file(GLOB found CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${folder}/*.cpp)
        list(FILTER found EXCLUDE REGEX "/main\\.cpp$")
        list(APPEND sources ${found})
    endforeach()
    if(sources)
        add_library(${name} STATIC ${sources})
        target_precompile_headers(${name} REUSE_FROM sl_headers)
        target_link_libraries(${name} PUBLIC sl_interface $<BUILD_INTERFACE:sl_options> ${ARG_LINK})
    else()
        add_library(${name} INTERFACE)
        target_link_libraries(${name} INTERFACE sl_interface $<BUILD_INTERFACE:sl_options> ${ARG_LINK})
    endif()
endfunction()
