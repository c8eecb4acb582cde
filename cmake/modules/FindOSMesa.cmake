# SPDX-License-Identifier: MIT
# Makes OSMesa::OSMesa: Mesa's software rasterizer without a window system.
find_library(OSMESA_LIBRARY OSMesa)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(OSMesa REQUIRED_VARS OSMESA_LIBRARY)
if(OSMesa_FOUND AND NOT TARGET OSMesa::OSMesa)
    add_library(OSMesa::OSMesa UNKNOWN IMPORTED)
    set_target_properties(OSMesa::OSMesa PROPERTIES IMPORTED_LOCATION ${OSMESA_LIBRARY})
endif()
