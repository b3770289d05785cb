# What an installation holds besides the rooms: the package's configuration, the command line and its data.
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/scrubjay)
set(data_dir ${CMAKE_INSTALL_DATADIR}/scrubjay)

get_property(SCRUBJAY_COMPONENTS GLOBAL PROPERTY SCRUBJAY_COMPONENTS)
get_property(SCRUBJAY_COMPONENT_TABLE GLOBAL PROPERTY SCRUBJAY_COMPONENT_TABLE)
configure_package_config_file(cmake/scrubjay-config.cmake.in ${PROJECT_BINARY_DIR}/scrubjay-config.cmake
  INSTALL_DESTINATION ${package_dir} NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/scrubjay-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/scrubjay-config.cmake ${PROJECT_BINARY_DIR}/scrubjay-config-version.cmake
  cmake/Findlz4.cmake DESTINATION ${package_dir})
install(FILES package.xml LICENSE DESTINATION ${data_dir})

install(FILES include/scrubjay/scrubjay_c.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/scrubjay)
if(SCRUBJAY_HOSTED)
  file(GLOB root_headers include/scrubjay/*.hpp)
  install(FILES ${root_headers} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/scrubjay)
endif()
if(TARGET scrubjay_cli)
  install(TARGETS scrubjay_cli RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  install(DIRECTORY worlds urdf DESTINATION ${data_dir})
endif()
