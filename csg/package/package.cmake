# Packages of Debian, by cpack: `cnrg` (the program with its plug-ins), `libcnrg-dev` (headers, static libraries, CMake
# package), `python3-cnrg`. dpkg-shlibdeps finds the shared libraries that each of them depends on.
#   cmake --workflow --preset package     builds them in build/package
find_program(CNRG_DPKG dpkg)
if(NOT CNRG_DPKG OR NOT CNRG_PROGRAM)
  return()
endif()
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_VENDOR "the authors of cnrg")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "exact Booleans of solids, surfaces, wires and points in one model")
set(description "Models are trees of shapes and operators. Every cell of the result is
computed in exact arithmetic: regions, faces, edges and vertices, with names
and materials. Results and their meshes are written for ParaView, Gmsh, Abaqus,
DAGMC and others.")
set(CPACK_STRIP_FILES ON)
set(CPACK_VERBATIM_VARIABLES ON)

set(CPACK_COMPONENTS_ALL program development)
if(CNRG_WITH_PYTHON)
  list(APPEND CPACK_COMPONENTS_ALL python)
endif()
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "the authors of cnrg <maintainers@cnrg.invalid>")
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME cnrg)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION math)
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION "${description}")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libcnrg-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
# What the targets name; the plug-ins, which programs with the library open, too, are those of the program.
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "cnrg (= ${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}), libgmp-dev, \
libmpfr-dev, libtbb-dev, libyaml-cpp-dev, zlib1g-dev, libexpat1-dev")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "${description}\n\nThis package holds the library for C++.")

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-cnrg)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA ${CMAKE_CURRENT_LIST_DIR}/postinst ${CMAKE_CURRENT_LIST_DIR}/prerm)
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_STRICT_PERMISSION ON)
if(CNRG_WITH_PYTHON)
  math(EXPR next "${Python_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
    "python3 (>= 3.${Python_VERSION_MINOR}~), python3 (<< 3.${next}~), python3-numpy")
endif()
set(CPACK_COMPONENT_PYTHON_DESCRIPTION "${description}\n\nThis package holds the module for Python.")

set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/documents.cmake)
set(CPACK_CNRG_SOURCES ${PROJECT_SOURCE_DIR})
include(CPack)
