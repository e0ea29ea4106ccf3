# cpack runs this before it packs: each package gets /usr/share/doc/PACKAGE, manual pages are compressed.

# compress(FILE TO): gzip with neither name nor time, so that the same files make the same package.
function(compress file to)
  execute_process(COMMAND gzip -9nc ${file} OUTPUT_FILE ${to} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

set(changes ${CPACK_CNRG_SOURCES}/.github/CHANGELOG.md)
file(STRINGS ${changes} release REGEX "^## \\[${CPACK_PACKAGE_VERSION}\\] - " LIMIT_COUNT 1)
string(REGEX REPLACE "^.* - " "" day "${release}")
if(NOT day)
  message(FATAL_ERROR "${changes} has no line `## [${CPACK_PACKAGE_VERSION}] - DATE`")
endif()
execute_process(COMMAND date -u -R -d ${day} OUTPUT_VARIABLE date OUTPUT_STRIP_TRAILING_WHITESPACE
  COMMAND_ERROR_IS_FATAL ANY)

foreach(component ${CPACK_COMPONENTS_ALL})
  string(TOUPPER ${component} upper)
  set(name ${CPACK_DEBIAN_${upper}_PACKAGE_NAME})
  set(share ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/${component}/usr/share)
  set(folder ${share}/doc/${name})
  file(MAKE_DIRECTORY ${folder})
  file(COPY ${CPACK_CNRG_SOURCES}/csg/package/copyright DESTINATION ${folder})
  compress(${changes} ${folder}/changelog.gz)
  file(WRITE ${folder}/changelog.Debian "${name} (${CPACK_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}) \
bookworm; urgency=medium\n\n  * Release ${CPACK_PACKAGE_VERSION}; changelog.gz says what is new.\n\n \
-- ${CPACK_DEBIAN_PACKAGE_MAINTAINER}  ${date}\n")
  compress(${folder}/changelog.Debian ${folder}/changelog.Debian.gz)
  file(REMOVE ${folder}/changelog.Debian)
  file(GLOB pages ${share}/man/man1/*.1)
  foreach(page ${pages})
    compress(${page} ${page}.gz)
    file(REMOVE ${page})
  endforeach()
endforeach()
