# Builds and installs the library opencv_gwatershed, and the samples, against an installed OpenCV.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Type of the build" FORCE)
endif()

find_package(OpenCV REQUIRED COMPONENTS core imgproc OPTIONAL_COMPONENTS imgcodecs videoio highgui ximgproc)
if(NOT DEFINED CMAKE_CXX_STANDARD)
  set(CMAKE_CXX_STANDARD 11)
  if(OpenCV_VERSION VERSION_GREATER_EQUAL 5)
    set(CMAKE_CXX_STANDARD 17)
  endif()
endif()

file(GLOB_RECURSE gwatershed_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/*.cpp)
option(BUILD_SHARED_LIBS "Build a shared library" ON)
option(BUILD_SAMPLES "Build the samples" ON)
option(BUILD_TESTS "Build the tests; they need GoogleTest" OFF)
add_library(opencv_gwatershed ${gwatershed_sources})
target_include_directories(opencv_gwatershed PUBLIC
  $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
target_include_directories(opencv_gwatershed PRIVATE ${PROJECT_SOURCE_DIR}/src)
target_link_libraries(opencv_gwatershed PUBLIC opencv_core opencv_imgproc)
set_target_properties(opencv_gwatershed PROPERTIES
  DEFINE_SYMBOL CVAPI_EXPORTS
  CXX_VISIBILITY_PRESET hidden
  VISIBILITY_INLINES_HIDDEN ON
  VERSION ${PROJECT_VERSION}
  SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  target_compile_options(opencv_gwatershed PRIVATE -Wall -Wextra)
  # GCC below 12 vectorises the loops over pixels from -O3 on only.
  target_compile_options(opencv_gwatershed PRIVATE $<$<CONFIG:Release>:-O3>)
endif()

if(NOT BUILD_SAMPLES)
  # nothing asked for
elseif(OpenCV_imgcodecs_FOUND AND OpenCV_videoio_FOUND AND OpenCV_highgui_FOUND)
  file(GLOB samples CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/samples/*.cpp)
  foreach(sample IN LISTS samples)
    get_filename_component(name ${sample} NAME_WE)
    add_executable(example_${name} ${sample})
    set_target_properties(example_${name} PROPERTIES OUTPUT_NAME ${name})
    target_link_libraries(example_${name} opencv_gwatershed opencv_imgcodecs opencv_videoio opencv_highgui)
  endforeach()
  # It calls the steps of RGWATERSHED one by one, which the library does not export.
  file(GLOB_RECURSE steps CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/shared/*.cpp ${PROJECT_SOURCE_DIR}/src/rgwatershed/*.cpp)
  target_sources(example_gwatershed_steps PRIVATE ${steps})
  target_include_directories(example_gwatershed_steps PRIVATE ${PROJECT_SOURCE_DIR}/src)
  if(OpenCV_ximgproc_FOUND)
    target_link_libraries(example_gwatershed_benchmark opencv_ximgproc)
    target_compile_definitions(example_gwatershed_benchmark PRIVATE GWATERSHED_HAVE_XIMGPROC)
  endif()
else()
  message(STATUS "gwatershed: the samples need imgcodecs, videoio and highgui; they are left out")
endif()

if(BUILD_TESTS)
  include(misc/cmake/tests.cmake)
endif()

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/gwatershed)
install(CODE "set(directories [[${package_dir}]] [[${CMAKE_INSTALL_INCLUDEDIR}/opencv2]])")
install(CODE "set(build_dir [[${PROJECT_BINARY_DIR}]])")
install(SCRIPT misc/cmake/note_directories.cmake)
install(TARGETS opencv_gwatershed EXPORT gwatershedTargets
  RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR}
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/opencv2 DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT gwatershedTargets DESTINATION ${package_dir})
configure_package_config_file(misc/cmake/gwatershedConfig.cmake.in gwatershedConfig.cmake
  INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(gwatershedConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/gwatershedConfig.cmake ${PROJECT_BINARY_DIR}/gwatershedConfigVersion.cmake
  DESTINATION ${package_dir})

add_custom_target(uninstall
  COMMAND ${CMAKE_COMMAND} "-Dbuild_dir=${PROJECT_BINARY_DIR}" -P ${CMAKE_CURRENT_LIST_DIR}/uninstall.cmake VERBATIM)
