# How every room of the house becomes a library.

# scrubjay_library(<room> [CORE] SOURCES <file>... [USES <room>...] [LINKS <third-party target>...])
#
# Makes scrubjay_<room> (alias scrubjay::<room>) from src/<room>, and the component <room> of the installed package.
# CORE rooms may be embedded: no exceptions, no RTTI. USES are rooms below, seen by users of this one. LINKS are imported
# targets of third parties, kept inside; the package that brings one is the name before its `::`, or its whole name, or
# the name behind it where there is no such package (SQLite::SQLite3).
function(scrubjay_library room)
  cmake_parse_arguments(PARSE_ARGV 1 arg "CORE" "" "SOURCES;USES;LINKS")
  if(arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "scrubjay_library(${room}): unknown argument ${arg_UNPARSED_ARGUMENTS}")
  endif()
  set(target scrubjay_${room})
  add_library(${target} STATIC ${arg_SOURCES})
  add_library(scrubjay::${room} ALIAS ${target})
  target_include_directories(${target} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_compile_features(${target} PUBLIC cxx_std_20)
  list(TRANSFORM arg_USES PREPEND scrubjay_ OUTPUT_VARIABLE used_targets)
  target_link_libraries(${target} PUBLIC ${used_targets} Eigen3::Eigen
    PRIVATE ${arg_LINKS} $<BUILD_INTERFACE:scrubjay_options>)
  if(arg_CORE)
    target_compile_options(${target} PRIVATE -fno-exceptions -fno-rtti)
    set_property(GLOBAL APPEND PROPERTY SCRUBJAY_CORE_ROOMS ${room})
  endif()
  scrubjay_share_imported_targets()

  set(packages Eigen3)
  foreach(link IN LISTS arg_LINKS)
    if(NOT TARGET ${link})
      message(FATAL_ERROR "scrubjay_library(${room}): LINKS ${link} is not an imported target, as in PNG::PNG")
    endif()
    string(REGEX REPLACE "::.*" "" package ${link})
    if(NOT ${package}_FOUND)
      string(REGEX REPLACE ".*::" "" package ${link})
    endif()
    list(APPEND packages ${package})
  endforeach()
  scrubjay_component(${room} USES ${arg_USES} PACKAGES ${packages})
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/scrubjay/${room} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/scrubjay)
endfunction()

# scrubjay_component(<name> [USES <component>...] [PACKAGES <third-party package>...])
#
# Makes scrubjay_<name> a component of the installed package: an export set of its own, and a line in the table that
# the package's configuration file reads.
function(scrubjay_component name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "USES;PACKAGES")
  list(REMOVE_DUPLICATES arg_PACKAGES)
  set_target_properties(scrubjay_${name} PROPERTIES EXPORT_NAME ${name})
  set_property(GLOBAL APPEND PROPERTY SCRUBJAY_COMPONENTS ${name})
  set_property(GLOBAL APPEND_STRING PROPERTY SCRUBJAY_COMPONENT_TABLE
    "set(scrubjay_${name}_USES \"${arg_USES}\")\nset(scrubjay_${name}_PACKAGES \"${arg_PACKAGES}\")\n")
  install(TARGETS scrubjay_${name} EXPORT scrubjay-${name} ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
  install(EXPORT scrubjay-${name} NAMESPACE scrubjay:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/scrubjay)
endfunction()

# A room's find_package is seen in its own folder only; whoever links the room must see what it links as well.
function(scrubjay_share_imported_targets)
  get_property(targets DIRECTORY PROPERTY IMPORTED_TARGETS)
  foreach(target IN LISTS targets)
    get_target_property(is_global ${target} IMPORTED_GLOBAL)
    if(NOT is_global)
      set_target_properties(${target} PROPERTIES IMPORTED_GLOBAL TRUE)
    endif()
  endforeach()
endfunction()
