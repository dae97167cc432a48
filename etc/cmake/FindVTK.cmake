# VTK from the runtime package (libvtk9.x) and the headers of libvtk9-dev that
# Allrun unpacks into the build folder. Used only with
#
#     cmake -DCMAKE_MODULE_PATH=<here> -DSPH_VTK=<folder it was unpacked into>
#
# Why: to install libvtk9-dev takes 360 packages more and 1.2 GB, and removes
# ParaView. Without these two settings CMake takes an installed libvtk9-dev.
file(GLOB VTK_INCLUDE_DIR ${SPH_VTK}/usr/include/vtk-9*)
string(REGEX MATCH "9\\.[0-9]+" VTK_VERSION "${VTK_INCLUDE_DIR}")

# What the components below link to publicly; each is one shared library
set(VTK_LIBRARIES "")
foreach(module
    CommonCore CommonMath CommonTransforms CommonDataModel
    CommonExecutionModel IOXMLParser IOXML
)
    find_library(VTK_${module}_LIBRARY
        NAMES libvtk${module}-${VTK_VERSION}.so.1 NO_CACHE
    )
    if(VTK_${module}_LIBRARY)
        list(APPEND VTK_LIBRARIES ${VTK_${module}_LIBRARY})
        set(VTK_${module}_FOUND TRUE)
    endif()
endforeach()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(VTK
    REQUIRED_VARS VTK_INCLUDE_DIR VTK_LIBRARIES
    VERSION_VAR VTK_VERSION
    HANDLE_COMPONENTS
)

foreach(module ${VTK_FIND_COMPONENTS})
    if(VTK_FOUND AND NOT TARGET VTK::${module})
        add_library(VTK::${module} INTERFACE IMPORTED)
        target_include_directories(VTK::${module}
            SYSTEM INTERFACE ${VTK_INCLUDE_DIR}
        )
        target_link_libraries(VTK::${module} INTERFACE ${VTK_LIBRARIES})
    endif()
endforeach()
