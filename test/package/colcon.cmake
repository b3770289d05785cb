# cmake -DSOURCE=<tree> -DWORK=<folder> -DTOOLCHAIN=<cmake option>... -P colcon.cmake
#
# Builds the core with colcon, as a workspace would, and looks at what it installed.
cmake_minimum_required(VERSION 3.22)

find_program(COLCON colcon)
if(NOT COLCON)
  message("skipped: colcon is not installed (Debian: apt-get install colcon python3-colcon-ros)")
  return()
endif()

file(MAKE_DIRECTORY ${WORK})
execute_process(COMMAND ${COLCON} list --base-paths ${SOURCE} WORKING_DIRECTORY ${WORK} OUTPUT_VARIABLE listing
  ERROR_QUIET)
message("colcon list: ${listing}")
execute_process(
  COMMAND ${COLCON} --log-base ${WORK}/log build --base-paths ${SOURCE}
    --build-base ${WORK}/build --install-base ${WORK}/install
    --cmake-args -GNinja -DSCRUBJAY_HOSTED=OFF -DSCRUBJAY_TESTS=OFF ${TOOLCHAIN}
  WORKING_DIRECTORY ${WORK} COMMAND_ERROR_IS_FATAL ANY)

foreach(file share/scrubjay/package.xml include/scrubjay/geometry/pose2.hpp lib*/libscrubjay_geometry.a
    lib*/cmake/scrubjay/scrubjay-config.cmake lib*/cmake/scrubjay/scrubjay-core.cmake)
  file(GLOB_RECURSE found ${WORK}/install/scrubjay/${file})
  if(NOT found)
    message(SEND_ERROR "${WORK}/install/scrubjay/${file} is missing after colcon build")
  endif()
endforeach()
