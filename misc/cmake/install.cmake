# Installs the library, and what CMake and pkg-config find it by. The components are those of the packages.
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/gwatershed)
install(CODE "set(directories
  [[${package_dir}]] [[${CMAKE_INSTALL_LIBDIR}/pkgconfig]] [[${CMAKE_INSTALL_INCLUDEDIR}/opencv2/gwatershed]])")
install(CODE "set(build_dir [[${PROJECT_BINARY_DIR}]])")
install(SCRIPT misc/cmake/note_directories.cmake)

install(TARGETS opencv_gwatershed EXPORT gwatershedTargets
  RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT library
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library NAMELINK_COMPONENT development
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/opencv2 DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
  COMPONENT development)
install(EXPORT gwatershedTargets DESTINATION ${package_dir} COMPONENT development)

# OpenCV keeps its binary interface within major.minor only.
set(opencv_series ${OpenCV_VERSION_MAJOR}.${OpenCV_VERSION_MINOR})
math(EXPR opencv_next_minor "${OpenCV_VERSION_MINOR} + 1")
set(opencv_next_series ${OpenCV_VERSION_MAJOR}.${opencv_next_minor})

configure_package_config_file(misc/cmake/gwatershedConfig.cmake.in gwatershedConfig.cmake
  INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(gwatershedConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/gwatershedConfig.cmake ${PROJECT_BINARY_DIR}/gwatershedConfigVersion.cmake
  DESTINATION ${package_dir} COMPONENT development)
file(RELATIVE_PATH pc_prefix "/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/")
string(REGEX REPLACE "/$" "" pc_prefix "${pc_prefix}")
configure_file(misc/cmake/gwatershed.pc.in gwatershed.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/gwatershed.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
  COMPONENT development)

if(is_top_level)
  add_custom_target(uninstall
    COMMAND ${CMAKE_COMMAND} "-Dbuild_dir=${PROJECT_BINARY_DIR}" -P ${CMAKE_CURRENT_LIST_DIR}/uninstall.cmake VERBATIM)
endif()
