# SPDX-License-Identifier: MIT
# Makes PkgConfig::OpenImageIO. The CMake configuration that Debian ships for it names a folder that does not exist.
find_package(PkgConfig)
if(PkgConfig_FOUND)
    pkg_check_modules(OpenImageIO QUIET IMPORTED_TARGET OpenImageIO)
endif()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(OpenImageIO REQUIRED_VARS OpenImageIO_LINK_LIBRARIES VERSION_VAR OpenImageIO_VERSION)
