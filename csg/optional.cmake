# Libraries that cnrg can be built without. Each has an option CNRG_NAME: AUTO (used where it can be), ON (an error where
# it cannot be), OFF. What comes of it is CNRG_WITH_NAME.

# cnrg_optional(NAME PURPOSE LACK PACKAGES): LACK says why it cannot be used, and is empty where it can.
function(cnrg_optional name purpose lack packages)
  set(CNRG_${name} AUTO CACHE STRING "${purpose}: AUTO, ON or OFF")
  set_property(CACHE CNRG_${name} PROPERTY STRINGS AUTO ON OFF)
  set(with OFF)
  if(NOT CNRG_${name})
    message(STATUS "${purpose}: no (CNRG_${name}=${CNRG_${name}})")
  elseif(NOT lack)
    message(STATUS "${purpose}: yes")
    set(with ON)
  elseif(CNRG_${name} STREQUAL "AUTO")
    message(STATUS "${purpose}: no, ${lack} (Debian: ${packages})")
  else()
    message(FATAL_ERROR "CNRG_${name} is ON, but ${lack}: install it (Debian: ${packages}), or set CNRG_${name}=OFF")
  endif()
  set(CNRG_WITH_${name} ${with} PARENT_SCOPE)
endfunction()

# missing(LACK WHAT VARIABLE...): LACK says which of them were not found, and which were all the same; of a package
# PACKAGE_FOUND that is there and cannot be used, what its CMake files say.
function(missing lack what)
  set(absent "")
  set(present "")
  foreach(variable ${ARGN})
    string(REGEX REPLACE "_FOUND$" "" package ${variable})
    if(${variable})
      list(APPEND present "${package}=${${variable}}")
    elseif(${package}_CONSIDERED_CONFIGS)
      list(APPEND absent "${package}, for ${${package}_CONSIDERED_CONFIGS} refuses: ${${package}_NOT_FOUND_MESSAGE}")
    else()
      list(APPEND absent ${package})
    endif()
  endforeach()
  list(JOIN absent ", " absent)
  list(JOIN present ", " present)
  set(${lack} "" PARENT_SCOPE)
  if(absent AND present)
    set(${lack} "${what} is installed in part (found: ${present}; not found: ${absent})" PARENT_SCOPE)
  elseif(absent)
    set(${lack} "${what} is not installed (not found: ${absent})" PARENT_SCOPE)
  endif()
endfunction()

find_package(ZLIB QUIET)
find_package(EXPAT QUIET)
missing(lack "what reads them" ZLIB_FOUND EXPAT_FOUND)
cnrg_optional(VTP "Leaves from .vtp, by Expat and zlib" "${lack}" "zlib1g-dev libexpat1-dev")
include(${CMAKE_CURRENT_LIST_DIR}/opencascade.cmake)
cnrg_optional(OPENCASCADE "STEP and BREP files, by OpenCASCADE" "${CNRG_OPENCASCADE_LACK}" libocct-data-exchange-dev)
if(NOT CNRG_PROGRAM)
  return()
endif()
if(NOT ZLIB_FOUND)
  message(FATAL_ERROR "CNRG_PROGRAM=ON needs zlib: install it (Debian: zlib1g-dev), or set CNRG_PROGRAM=OFF")
endif()

# Without MPI, as Debian calls it, or as it is.
find_path(CNRG_HDF5_INCLUDE hdf5.h PATH_SUFFIXES hdf5/serial)
find_library(CNRG_HDF5_LIBRARY NAMES hdf5_serial hdf5)
missing(lack HDF5 CNRG_HDF5_INCLUDE CNRG_HDF5_LIBRARY)
cnrg_optional(HDF5 "Files .h5m and .med, by HDF5" "${lack}" libhdf5-dev)

find_path(CNRG_CAIRO_INCLUDE cairo/cairo-ft.h)
find_library(CNRG_CAIRO_LIBRARY cairo)
find_package(Freetype QUIET)
# The font becomes part of the plug-in.
find_file(CNRG_FONT DejaVuSans.ttf PATHS /usr/share/fonts PATH_SUFFIXES truetype/dejavu dejavu TTF dejavu-sans-fonts
  NO_DEFAULT_PATH)
missing(lack "what pictures need" CNRG_CAIRO_INCLUDE CNRG_CAIRO_LIBRARY FREETYPE_FOUND CNRG_FONT)
cnrg_optional(CAIRO "Pictures, by cairo" "${lack}" "libcairo2-dev libfreetype-dev fonts-dejavu-core")

# TetGen says its version in a comment of its header only.
find_path(CNRG_TETGEN_INCLUDE tetgen.h)
find_library(CNRG_TETGEN_LIBRARY tet)
missing(lack TetGen CNRG_TETGEN_INCLUDE CNRG_TETGEN_LIBRARY)
cnrg_optional(TETGEN "Tetrahedra by TetGen (AGPL)" "${lack}" libtet1.5-dev)

# The page of `cnrg view`; csg/view/web/bundle says what happens without the network.
find_program(CNRG_NODE node)
find_program(CNRG_NPM npm)
missing(lack Node.js CNRG_NODE CNRG_NPM)
cnrg_optional(VIEW "The page of cnrg view, bundled by Node.js" "${lack}" "nodejs npm")

# The module for Python, by the system's own interpreter, for which numpy and the others are packaged.
if(CNRG_SANITIZE OR CNRG_SANITIZE_THREADS OR CNRG_FUZZ)
  set(lack "a sanitizer cannot be loaded into an interpreter")
else()
  if(NOT Python_EXECUTABLE AND EXISTS /usr/bin/python3)
    set(Python_EXECUTABLE /usr/bin/python3)
  endif()
  find_package(Python COMPONENTS Interpreter Development.Module QUIET)
  find_package(pybind11 QUIET)
  missing(lack "what it is built with" Python_FOUND pybind11_FOUND)
endif()
cnrg_optional(PYTHON "The Python module" "${lack}" "pybind11-dev python3-dev")
