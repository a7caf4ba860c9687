# Before an install: notes which of the directories, and of those above them, it is going to make. The inner ones come
# first, as uninstall.cmake removes them.
foreach(directory IN LISTS directories)
  get_filename_component(directory "${directory}" ABSOLUTE BASE_DIR "${CMAKE_INSTALL_PREFIX}")
  get_filename_component(parent "${directory}" DIRECTORY)
  while(NOT EXISTS "$ENV{DESTDIR}${directory}" AND NOT parent STREQUAL directory)
    file(APPEND "${build_dir}/install_directories.txt" "${directory}\n")
    set(directory "${parent}")
    get_filename_component(parent "${directory}" DIRECTORY)
  endwhile()
endforeach()
