# SPDX-License-Identifier: MIT
#
# In place of Zephyr's package: the functions that module and sample call, as their documentation
# describes them, in plain CMake. CONFIG names a file that sets CONFIG_..., as Kconfig would.
project(mock C)
include(${CONFIG})

add_library(zephyr_interface INTERFACE)
add_executable(app ${CMAKE_CURRENT_LIST_DIR}/zephyr.c)
target_compile_options(app PRIVATE -std=gnu11 -Wall -Wextra -Werror)
target_include_directories(app PRIVATE ${CMAKE_CURRENT_LIST_DIR})
target_link_libraries(app PRIVATE zephyr_interface)

macro(zephyr_library_named name)
  add_library(${name} STATIC)
  target_link_libraries(${name} PUBLIC zephyr_interface)
  target_link_libraries(app PRIVATE ${name} m)
  set(current ${name})
endmacro()
function(zephyr_library_sources)
  target_sources(${current} PRIVATE ${ARGN})
endfunction()
function(zephyr_library_compile_options)
  target_compile_options(${current} PRIVATE ${ARGN})
endfunction()
function(zephyr_include_directories)
  target_include_directories(zephyr_interface INTERFACE ${ARGN})
endfunction()
function(zephyr_compile_definitions)
  target_compile_definitions(zephyr_interface INTERFACE ${ARGN})
endfunction()

foreach(module ${ZEPHYR_EXTRA_MODULES})
  add_subdirectory(${module}/zephyr modules)
endforeach()
