# cmake -DCACHE=<CMakeCache.txt> -DALLOWED=<package>... -P check_cache.cmake
#
# A project that has looked for a package keeps <package>_DIR, found or not, or the variables of its find module.
cmake_minimum_required(VERSION 3.22)

file(STRINGS ${CACHE} entries REGEX "^[^:]+:(PATH|FILEPATH)=")
foreach(entry IN LISTS entries)
  string(REGEX REPLACE ":.*" "" name ${entry})
  if(name MATCHES "^CMAKE_")
    continue()
  endif()
  string(REGEX REPLACE "_(DIR|LIBRARY.*|INCLUDE_DIR.*)$" "" package ${name})
  if(NOT package IN_LIST ALLOWED)
    message(SEND_ERROR "${CACHE}: looked for ${package} (${entry}); want nothing but: ${ALLOWED}")
  else()
    list(APPEND seen ${package})
  endif()
endforeach()
foreach(package IN LISTS ALLOWED)
  if(NOT package IN_LIST seen)
    message(SEND_ERROR "${CACHE}: no trace of ${package}; this check looks at the wrong entries")
  endif()
endforeach()
