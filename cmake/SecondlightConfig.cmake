# SPDX-License-Identifier: MIT
# find_package(Secondlight 0.1) gives Secondlight::Secondlight, the whole engine, and its layers: Secondlight::ecs,
# Secondlight::render and so on.
include(${CMAKE_CURRENT_LIST_DIR}/dependencies.cmake)
if(DEFINED Secondlight_FOUND AND NOT Secondlight_FOUND)
    return()
endif()
include(${CMAKE_CURRENT_LIST_DIR}/SecondlightTargets.cmake)
