# OpenCASCADE, whichever names its toolkits have: since 7.8 TKDESTEP holds what TKSTEP, TKSTEPBase, TKSTEPAttr and
# TKXDESTEP held. Sets
#   CNRG_OPENCASCADE_TOOLKITS  the targets that STEP and BREP files need; empty where they cannot be had
#   CNRG_OPENCASCADE_LACK      why they cannot be had, without a full stop; empty where they can
# and cnrg_toolkits, by which tests find theirs.
if(NOT OpenCASCADE_DIR OR EXISTS "${OpenCASCADE_DIR}/OpenCASCADEConfig.cmake")  # as cnrg_find; this file stands alone
  find_package(OpenCASCADE QUIET)
endif()

# cnrg_toolkits(FOUND LACKING TOOLKIT...): the targets for toolkits by their names before 7.8, and the toolkits that have
# no target.
function(cnrg_toolkits found lacking)
  set(targets "")
  set(without "")
  foreach(toolkit ${ARGN})
    set(renamed OFF)
    if(toolkit MATCHES "^TK(STEP|STEPBase|STEPAttr|XDESTEP)$")
      set(renamed ON)
    endif()
    if(TARGET ${toolkit})
      list(APPEND targets ${toolkit})
    elseif(renamed AND TARGET TKDESTEP)
      list(APPEND targets TKDESTEP)
    elseif(renamed)
      list(APPEND without "${toolkit} (TKDESTEP since 7.8)")
    else()
      list(APPEND without ${toolkit})
    endif()
  endforeach()
  list(REMOVE_DUPLICATES targets)
  list(JOIN without ", " without)
  set(${found} "${targets}" PARENT_SCOPE)
  set(${lacking} "${without}" PARENT_SCOPE)
endfunction()

set(CNRG_OPENCASCADE_TOOLKITS "")
set(CNRG_OPENCASCADE_LACK "")
if(OpenCASCADE_FOUND)
  cnrg_toolkits(CNRG_OPENCASCADE_TOOLKITS lacking TKSTEP TKSTEPBase TKSTEPAttr TKXSBase TKMesh TKTopAlgo TKGeomAlgo TKBRep
    TKGeomBase TKG3d TKG2d TKMath TKernel)
  if(lacking)
    set(CNRG_OPENCASCADE_LACK "OpenCASCADE ${OpenCASCADE_VERSION} in ${OpenCASCADE_DIR} lacks ${lacking}")
  elseif(NOT EXISTS "${OpenCASCADE_INCLUDE_DIR}/STEPControl_Reader.hxx")
    set(CNRG_OPENCASCADE_LACK
      "OpenCASCADE ${OpenCASCADE_VERSION} lacks ${OpenCASCADE_INCLUDE_DIR}/STEPControl_Reader.hxx")
  endif()
elseif(OpenCASCADE_CONSIDERED_CONFIGS)
  set(CNRG_OPENCASCADE_LACK "${OpenCASCADE_CONSIDERED_CONFIGS} refuses: ${OpenCASCADE_NOT_FOUND_MESSAGE}")
elseif(OpenCASCADE_DIR)
  set(CNRG_OPENCASCADE_LACK "OpenCASCADE_DIR=${OpenCASCADE_DIR} is without OpenCASCADEConfig.cmake")
else()
  set(CNRG_OPENCASCADE_LACK "OpenCASCADE is not installed (no OpenCASCADEConfig.cmake)")
endif()
if(CNRG_OPENCASCADE_LACK)
  set(CNRG_OPENCASCADE_TOOLKITS "")
endif()
