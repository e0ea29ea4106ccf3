# Libraries that cnrg can be built without. Each has an option CNRG_NAME: AUTO (used where it can be), ON (an error where
# it cannot be), OFF. What comes of it is CNRG_WITH_NAME.

# cnrg_optional(NAME PURPOSE LACK PACKAGES): LACK says why it cannot be used, and is empty where it can;
# PACKAGES are empty where none would help.
function(cnrg_optional name purpose lack packages)
  set(CNRG_${name} AUTO CACHE STRING "${purpose}: AUTO, ON or OFF")
  set_property(CACHE CNRG_${name} PROPERTY STRINGS AUTO ON OFF)
  if(NOT CNRG_${name} MATCHES "^(AUTO|ON|OFF)$")
    message(FATAL_ERROR "CNRG_${name} is '${CNRG_${name}}': it can be AUTO, ON or OFF")
  endif()
  set(debian "")
  set(install "")
  if(packages)
    set(debian " (Debian: ${packages})")
    set(install "install it${debian}, or ")
  endif()
  set(with OFF)
  if(NOT CNRG_${name})
    message(STATUS "${purpose}: no (CNRG_${name}=${CNRG_${name}})")
  elseif(NOT lack)
    message(STATUS "${purpose}: yes")
    set(with ON)
  elseif(CNRG_${name} STREQUAL "AUTO")
    message(STATUS "${purpose}: no, ${lack}${debian}")
  else()
    message(FATAL_ERROR "CNRG_${name} is ON, but ${lack}: ${install}set CNRG_${name}=OFF")
  endif()
  set(CNRG_WITH_${name} ${with} PARENT_SCOPE)
endfunction()

# usable(LACK WHAT HEADERS FOLDERS LIBRARIES): LACK, if it is empty, says why no program can be compiled with the headers
# and linked with the libraries.
function(usable variable what headers folders libraries)
  string(SHA1 key "${headers};${folders};${libraries};${CMAKE_CXX_FLAGS};${CMAKE_CXX_COMPILER}")
  if(${variable} OR CNRG_USABLE_${key})
    return()
  endif()
  list(TRANSFORM headers REPLACE "(.+)" "#include <\\1>\n")
  list(JOIN headers "" headers)
  try_compile(CNRG_USABLE_${key} SOURCE_FROM_CONTENT usable.cpp "${headers}int main() {}\n"
    CMAKE_FLAGS "-DINCLUDE_DIRECTORIES=${folders}" LINK_LIBRARIES ${libraries} OUTPUT_VARIABLE said)
  if(NOT CNRG_USABLE_${key})
    unset(CNRG_USABLE_${key} CACHE)  # to be asked again
    string(REGEX MATCH "[^\n]*(error|cannot find)[^\n]*" reason "${said}")
    set(${variable} "${what} is there, and nothing can be built with it: ${reason}" PARENT_SCOPE)
  endif()
endfunction()

find_package(ZLIB QUIET)
find_package(EXPAT QUIET)
missing(lack "what reads them" ZLIB_LIBRARIES EXPAT_LIBRARIES)
cnrg_optional(VTP "Leaves from .vtp, by Expat and zlib" "${lack}" "zlib1g-dev libexpat1-dev")
include(${CMAKE_CURRENT_LIST_DIR}/opencascade.cmake)
cnrg_optional(OPENCASCADE "STEP and BREP files, by OpenCASCADE" "${CNRG_OPENCASCADE_LACK}" libocct-data-exchange-dev)
if(NOT CNRG_PROGRAM)
  foreach(name HDF5 CAIRO TETGEN VIEW PYTHON BENCH)
    if(CNRG_${name} AND NOT CNRG_${name} STREQUAL "AUTO")
      message(FATAL_ERROR "CNRG_${name}=${CNRG_${name}} needs the whole program: set CNRG_PROGRAM=ON, or leave it out")
    endif()
  endforeach()
  return()
endif()
# Without MPI, as Debian calls it, or as it is.
find_path(CNRG_HDF5_INCLUDE hdf5.h PATH_SUFFIXES hdf5/serial)
find_library(CNRG_HDF5_LIBRARY NAMES hdf5_serial hdf5)
missing(lack HDF5 CNRG_HDF5_INCLUDE CNRG_HDF5_LIBRARY)
usable(lack HDF5 hdf5.h "${CNRG_HDF5_INCLUDE}" "${CNRG_HDF5_LIBRARY}")
cnrg_optional(HDF5 "Files .h5m and .med, by HDF5" "${lack}" libhdf5-dev)

find_path(CNRG_CAIRO_INCLUDE cairo/cairo-ft.h)
find_library(CNRG_CAIRO_LIBRARY cairo)
find_package(Freetype QUIET)
# The font becomes part of the plug-in.
find_file(CNRG_FONT DejaVuSans.ttf PATHS /usr/share/fonts PATH_SUFFIXES truetype/dejavu dejavu TTF dejavu-sans-fonts
  NO_DEFAULT_PATH)
missing(lack "what pictures need" CNRG_CAIRO_INCLUDE CNRG_CAIRO_LIBRARY FREETYPE_LIBRARIES CNRG_FONT)
usable(lack "what pictures need" "ft2build.h;cairo/cairo-ft.h" "${CNRG_CAIRO_INCLUDE};${FREETYPE_INCLUDE_DIRS}"
  "${CNRG_CAIRO_LIBRARY};${FREETYPE_LIBRARIES}")
cnrg_optional(CAIRO "Pictures, by cairo" "${lack}" "libcairo2-dev libfreetype-dev fonts-dejavu-core")

# TetGen says its version in a comment of its header only.
find_path(CNRG_TETGEN_INCLUDE tetgen.h)
find_library(CNRG_TETGEN_LIBRARY tet)
missing(lack TetGen CNRG_TETGEN_INCLUDE CNRG_TETGEN_LIBRARY)
usable(lack TetGen tetgen.h "${CNRG_TETGEN_INCLUDE}" "${CNRG_TETGEN_LIBRARY}")
cnrg_optional(TETGEN "Tetrahedra by TetGen (AGPL)" "${lack}" libtet1.5-dev)

# The page of `cnrg view`; csg/view/web/bundle says what happens without the network.
find_program(CNRG_NODE node)
find_program(CNRG_NPM npm)
missing(lack Node.js CNRG_NODE CNRG_NPM)
if(NOT lack)  # as package-lock.json asks
  execute_process(COMMAND ${CNRG_NODE} --version OUTPUT_VARIABLE said ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(NOT said MATCHES "^v([0-9]+)[0-9.]*$" OR CMAKE_MATCH_1 LESS 18)
    set(lack "${CNRG_NODE} is no Node.js of version 18 or later, but '${said}'")
  endif()
endif()
cnrg_optional(VIEW "The page of cnrg view, bundled by Node.js" "${lack}" "nodejs npm")

# The module for Python, by the system's own interpreter, for which numpy and the others are packaged.
if(CNRG_SANITIZE OR CNRG_SANITIZE_THREADS OR CNRG_FUZZ)
  set(packages "")
  set(lack "a sanitizer cannot be loaded into an interpreter")
else()
  if(NOT Python_EXECUTABLE AND EXISTS /usr/bin/python3)
    set(Python_EXECUTABLE /usr/bin/python3)
  endif()
  find_package(Python COMPONENTS Interpreter Development.Module QUIET)
  if(Python_FOUND)  # it would look for another, and end with an error of its own
    cnrg_find(pybind11)
    missing(lack pybind11 pybind11_FOUND)
  elseif(Python_EXECUTABLE)
    set(lack "${Python_EXECUTABLE} is no Python 3 with headers")
  else()
    missing(lack Python Python_FOUND)
  endif()
  set(packages "pybind11-dev python3-dev")
endif()
cnrg_optional(PYTHON "The Python module" "${lack}" "${packages}")
