# How the house is compiled: build type, cache, warnings, sanitizers.

if(PROJECT_IS_TOP_LEVEL)
  if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
    set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
  endif()
  find_program(SCRUBJAY_CCACHE ccache)
  mark_as_advanced(SCRUBJAY_CCACHE)
  if(SCRUBJAY_CCACHE AND NOT DEFINED CMAKE_CXX_COMPILER_LAUNCHER)
    set(CMAKE_CXX_COMPILER_LAUNCHER ${SCRUBJAY_CCACHE})
  endif()
endif()

if(SCRUBJAY_LTO)
  include(CheckIPOSupported)
  check_ipo_supported(LANGUAGES CXX)
  set(CMAKE_INTERPROCEDURAL_OPTIMIZATION ON)
endif()

# A directory's flags, not a target's: every object and every program of ours must agree on them.
if(SCRUBJAY_SANITIZE)
  add_compile_options(-fsanitize=${SCRUBJAY_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${SCRUBJAY_SANITIZE})
  if(SCRUBJAY_SANITIZE MATCHES "undefined")
    add_compile_options(-fno-sanitize=vptr)  # looks for the RTTI that the core doesn't have
  endif()
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # GCC documents that sanitizers make it see ghosts here, in the standard library's own std::regex for one.
    add_compile_options(-Wno-maybe-uninitialized)
  endif()
endif()

# What our own code is compiled with and nobody who links it has to know.
add_library(scrubjay_options INTERFACE)
target_compile_options(scrubjay_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion
  $<$<COMPILE_LANGUAGE:CXX>:-Wnon-virtual-dtor> $<$<COMPILE_LANGUAGE:CXX>:-Wold-style-cast>
  # No fused multiply-add behind our back: results must be the same bits on every machine.
  -ffp-contract=off)
# Where several sources are compiled as one, compilers take each for a header of the others.
if(CMAKE_UNITY_BUILD)
  target_compile_options(scrubjay_options INTERFACE
    -Wno-shadow $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
endif()
if(SCRUBJAY_WERROR)
  target_compile_options(scrubjay_options INTERFACE -Werror)
endif()
