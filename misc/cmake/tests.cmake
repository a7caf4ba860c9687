# Builds the tests against an installed OpenCV and an installed GoogleTest, without OpenCV's test module ts.
find_package(GTest REQUIRED)
find_package(Threads REQUIRED)

file(GLOB tests CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/test/*.cpp)
list(REMOVE_ITEM tests ${PROJECT_SOURCE_DIR}/test/test_main.cpp)
add_executable(opencv_test_gwatershed ${tests} ${PROJECT_SOURCE_DIR}/tools/alone/main.cpp)
target_include_directories(opencv_test_gwatershed PRIVATE ${PROJECT_SOURCE_DIR}/tools/alone)
target_link_libraries(opencv_test_gwatershed opencv_gwatershed GTest::gtest Threads::Threads)

# The language of the library, or the later one that this GoogleTest is written in.
set(standard ${CMAKE_CXX_STANDARD})
if(GTest_VERSION VERSION_GREATER_EQUAL 1.13 AND standard LESS 14)
  set(standard 14)
endif()
if(GTest_VERSION VERSION_GREATER_EQUAL 1.17 AND standard LESS 17)
  set(standard 17)
endif()
set_target_properties(opencv_test_gwatershed PROPERTIES CXX_STANDARD ${standard})

if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  # The tests call INSTANTIATE_TEST_CASE_P by the name that it has in ts; GoogleTest has a newer one, too.
  target_compile_options(opencv_test_gwatershed PRIVATE -Wall -Wextra -Wno-deprecated-declarations)
endif()

enable_testing()
add_test(NAME opencv_test_gwatershed COMMAND opencv_test_gwatershed)
