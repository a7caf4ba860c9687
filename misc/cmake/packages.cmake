# Debian packages, by cpack in the build folder: the library, what programs are built with, and Python's package where
# BUILD_PYTHON is ON. They are for the release of Debian that they are made on.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_CONTACT "The developers of gwatershed <gwatershed@localhost>")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION "superpixels by a marker-controlled watershed, for OpenCV")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_COMPONENTS_ALL library development)

set(library_package libopencv-gwatershed${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME ${library_package})
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_COMPONENT_LIBRARY_DESCRIPTION "The library.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libopencv-gwatershed-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
  "${library_package} (= ${PROJECT_VERSION})"
  "libopencv-dev (>= ${opencv_series})"
  "libopencv-dev (<< ${opencv_next_series}~)")
list(JOIN CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS ", " CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS)
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "The header, and files for CMake and pkg-config.")

if(BUILD_PYTHON AND NOT SKBUILD)
  list(APPEND CPACK_COMPONENTS_ALL python)
  set(python_dir lib/python3/dist-packages)
  set(dist_info_dir ${python_dir}/gwatershed-${PROJECT_VERSION}.dist-info)
  # For the packages alone: Python does not look where cmake --install would put it.
  install(TARGETS gwatershed_python DESTINATION ${python_dir}/gwatershed COMPONENT python EXCLUDE_FROM_ALL)
  install(DIRECTORY python/gwatershed DESTINATION ${python_dir} COMPONENT python EXCLUDE_FROM_ALL
    PATTERN __pycache__ EXCLUDE)
  configure_file(python/debian/METADATA.in METADATA @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/METADATA python/debian/entry_points.txt
    DESTINATION ${dist_info_dir} COMPONENT python EXCLUDE_FROM_ALL)
  install(PROGRAMS python/debian/gwatershed python/debian/gwatershed-tiles
    DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT python EXCLUDE_FROM_ALL)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-gwatershed)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
  math(EXPR python_next "${Python_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
    "python3 (>= 3.${Python_VERSION_MINOR}~), python3 (<< 3.${python_next}~), python3-numpy")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS python3-pil)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-dask, python3-distributed, python3-zarr, python3-rasterio")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA
    "${PROJECT_SOURCE_DIR}/python/debian/postinst;${PROJECT_SOURCE_DIR}/python/debian/prerm")
  set(CPACK_COMPONENT_PYTHON_DESCRIPTION "The Python package gwatershed, and its commands.")
endif()

include(CPack)
