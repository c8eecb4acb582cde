# SPDX-License-Identifier: MIT
# Every library is a Debian 12 package; cmake/packages.txt lists what ./play and ./check install.
set(OpenGL_GL_PREFERENCE GLVND)
find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)
find_package(glfw3 3.3 REQUIRED)
find_package(glm REQUIRED)
find_package(spdlog REQUIRED)
find_package(fmt REQUIRED)
find_package(CLI11 REQUIRED)
find_package(nlohmann_json 3.11 REQUIRED)
find_package(TBB REQUIRED)
find_package(embree 3 REQUIRED)
find_package(OpenGL REQUIRED COMPONENTS EGL OpenGL)
# The CMake configuration that Debian ships for OpenImageIO names a folder that does not exist.
pkg_check_modules(OpenImageIO REQUIRED IMPORTED_TARGET OpenImageIO)
pkg_check_modules(imgui REQUIRED IMPORTED_TARGET imgui)
pkg_check_modules(sqlite3 REQUIRED IMPORTED_TARGET sqlite3)
find_library(OSMESA_LIBRARY OSMesa REQUIRED)
