# Builds the library opencv_gwatershed, the samples, the tests and the Python package beside an installed OpenCV.
include(GNUInstallDirs)

set(is_top_level OFF) # no part of another project
if(CMAKE_SOURCE_DIR STREQUAL PROJECT_SOURCE_DIR)
  set(is_top_level ON)
endif()
if(is_top_level AND NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Type of the build" FORCE)
endif()

find_package(OpenCV REQUIRED COMPONENTS core imgproc OPTIONAL_COMPONENTS imgcodecs videoio highgui ximgproc)
set(least_standard 11)
if(OpenCV_VERSION VERSION_GREATER_EQUAL 5)
  set(least_standard 17)
endif()
if(NOT DEFINED CMAKE_CXX_STANDARD)
  set(CMAKE_CXX_STANDARD ${least_standard})
endif()

file(GLOB_RECURSE gwatershed_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/*.cpp)
option(BUILD_SHARED_LIBS "Build a shared library" ON)
option(BUILD_SAMPLES "Build the samples" ${is_top_level})
option(BUILD_TESTS "Build the tests; they need GoogleTest" OFF)
option(BUILD_PYTHON "Build the Python package; it needs pybind11" OFF)
option(GWATERSHED_INSTALL "Install the library; off in another project" ${is_top_level})
# The code is compiled once, for the library and for Python.
add_library(gwatershed_objects OBJECT ${gwatershed_sources})
target_include_directories(gwatershed_objects PRIVATE ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR}/include)
target_link_libraries(gwatershed_objects PRIVATE opencv_core opencv_imgproc)
set_target_properties(gwatershed_objects PROPERTIES
  CXX_VISIBILITY_PRESET hidden
  VISIBILITY_INLINES_HIDDEN ON)
if(BUILD_SHARED_LIBS OR BUILD_PYTHON)
  set_target_properties(gwatershed_objects PROPERTIES POSITION_INDEPENDENT_CODE ON)
endif()
if(BUILD_SHARED_LIBS)
  target_compile_definitions(gwatershed_objects PRIVATE CVAPI_EXPORTS)
endif()
if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  target_compile_options(gwatershed_objects PRIVATE -Wall -Wextra)
  # A product that is added is rounded first, on each processor, so that labels are the same.
  set(same_everywhere -ffp-contract=off)
  target_compile_options(gwatershed_objects PRIVATE ${same_everywhere})
  # GCC below 12 vectorises the loops over pixels from -O3 on only.
  target_compile_options(gwatershed_objects PRIVATE $<$<CONFIG:Release>:-O3>)
endif()

add_library(opencv_gwatershed $<TARGET_OBJECTS:gwatershed_objects>)
add_library(gwatershed::gwatershed ALIAS opencv_gwatershed)
target_include_directories(opencv_gwatershed PUBLIC
  $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
target_link_libraries(opencv_gwatershed PUBLIC opencv_core opencv_imgproc)
target_compile_features(opencv_gwatershed INTERFACE cxx_std_${least_standard})
set_target_properties(opencv_gwatershed PROPERTIES
  LINKER_LANGUAGE CXX
  VERSION ${PROJECT_VERSION}
  SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})

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
  target_compile_options(example_gwatershed_steps PRIVATE ${same_everywhere})
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
if(BUILD_PYTHON)
  add_subdirectory(python)
endif()

if(GWATERSHED_INSTALL)
  include(misc/cmake/install.cmake)
endif()
if(is_top_level)
  include(misc/cmake/packages.cmake)
endif()
