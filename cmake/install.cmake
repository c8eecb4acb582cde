# SPDX-License-Identifier: MIT
# What `cmake --install` copies: the program with its data, and the engine as a CMake package for programs of others. Nothing of
# it knows where the prefix is, so all of it can be moved together.
include(CMakePackageConfigHelpers)
set(SL_PACKAGE ${CMAKE_INSTALL_LIBDIR}/cmake/Secondlight)

install(TARGETS secondlight RUNTIME DESTINATION bin)
install(DIRECTORY shader DESTINATION ${SL_DATA})
install(DIRECTORY game/scenes DESTINATION ${SL_DATA}/game)
install(FILES game/gi_presets.json DESTINATION ${SL_DATA}/game)
install(FILES LICENSE ASSETS.md DESTINATION share/doc/secondlight)

# Headers that C++ and GLSL share stay with the shaders: both find them there.
install(DIRECTORY engine DESTINATION ${SL_HEADERS} FILES_MATCHING PATTERN *.h)
install(DIRECTORY ${GLAD_FOLDER}/include/ DESTINATION ${SL_HEADERS})

set(parts core gltf measure model ecs gl graph scene trace reference facets render)
foreach(part ${parts} interface)
    set_target_properties(sl_${part} PROPERTIES EXPORT_NAME ${part})
    install(TARGETS sl_${part} EXPORT Secondlight ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}/secondlight)
endforeach()
set_target_properties(sl_engine PROPERTIES EXPORT_NAME Secondlight)
install(TARGETS sl_engine glad EXPORT Secondlight)
install(EXPORT Secondlight NAMESPACE Secondlight:: DESTINATION ${SL_PACKAGE} FILE SecondlightTargets.cmake)
install(FILES cmake/SecondlightConfig.cmake cmake/dependencies.cmake DESTINATION ${SL_PACKAGE})
install(DIRECTORY cmake/modules DESTINATION ${SL_PACKAGE})
write_basic_package_version_file(${CMAKE_BINARY_DIR}/SecondlightConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/SecondlightConfigVersion.cmake DESTINATION ${SL_PACKAGE})
