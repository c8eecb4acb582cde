# SPDX-License-Identifier: MIT
# What the engine links. The build reads this, and so does the installed package on behalf of programs that use the engine.
# Every library is a Debian 12 package; cmake/packages.txt lists what ./play and ./check install.
include(CMakeFindDependencyMacro)
set(OpenGL_GL_PREFERENCE GLVND)
list(PREPEND CMAKE_MODULE_PATH ${CMAKE_CURRENT_LIST_DIR}/modules)
find_dependency(Threads)
find_dependency(glfw3 3.3)
find_dependency(glm)
find_dependency(spdlog)
find_dependency(fmt)
find_dependency(nlohmann_json 3.11)
find_dependency(TBB)
find_dependency(embree 3)
find_dependency(OpenGL COMPONENTS EGL OpenGL)
find_dependency(OpenImageIO)
find_dependency(OSMesa)
list(POP_FRONT CMAKE_MODULE_PATH)
