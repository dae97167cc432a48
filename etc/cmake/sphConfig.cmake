# find_package(sph): the target sph::sph, with the flags that make a user's model
# fit the library (its registers, precision and alignment)
include(CMakeFindDependencyMacro)
find_dependency(OpenMP COMPONENTS CXX)
find_dependency(Eigen3 3.4 NO_MODULE)
include(${CMAKE_CURRENT_LIST_DIR}/sphTargets.cmake)
