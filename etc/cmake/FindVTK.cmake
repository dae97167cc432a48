# VTK from its runtime package (libvtk9.x) and the headers of libvtk9-dev that
# Allrun unpacks into the build folder. Used only with
#
#     cmake -DCMAKE_MODULE_PATH=<this folder> -DSPH_VTK=<where they lie>
#
# Without these CMake takes an installed libvtk9-dev. Why not that one: see
# README.md, Dependencies.
file(GLOB VTK_INCLUDE_DIR ${SPH_VTK}/usr/include/vtk-9*)
string(REGEX MATCH "9\\.[0-9]+$" VTK_VERSION "${VTK_INCLUDE_DIR}")

# The components in use and what they link to publicly, a library each
set(VTK_LIBRARIES "")
foreach(module
    CommonCore CommonMath CommonTransforms CommonDataModel
    CommonExecutionModel FiltersCore IOXMLParser IOXML IOLegacy IOGeometry
)
    file(GLOB files
        /usr/lib/${CMAKE_LIBRARY_ARCHITECTURE}/libvtk${module}-${VTK_VERSION}.so.*
    )
    if(files)
        list(GET files 0 file)
        list(APPEND VTK_LIBRARIES ${file})
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
