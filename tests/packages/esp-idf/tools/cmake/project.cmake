# SPDX-License-Identifier: MIT
#
# In place of ESP-IDF's file of this name: project() and idf_component_register(), as their
# documentation describes them, in plain CMake. CONFIG names a file that sets CONFIG_..., as Kconfig
# would. esp_idf.c stands for the components that the example requires.
set(mock ${CMAKE_CURRENT_LIST_DIR}/../..)

macro(idf_component_register)
  cmake_parse_arguments(_ "" "" "SRCS;INCLUDE_DIRS;REQUIRES" ${ARGN})
  get_filename_component(component ${CMAKE_CURRENT_LIST_DIR} NAME)
  set(COMPONENT_LIB __idf_${component})
  add_library(${COMPONENT_LIB} STATIC ${__SRCS})
  target_include_directories(${COMPONENT_LIB} PUBLIC ${__INCLUDE_DIRS})
  list(TRANSFORM __REQUIRES PREPEND __idf_)
  target_link_libraries(${COMPONENT_LIB} PUBLIC ${__REQUIRES} m)
endmacro()

macro(project name)
  _project(${name} C)
  include(${CONFIG})
  add_library(__idf_esp_driver_i2c STATIC ${mock}/esp_idf.c)
  target_include_directories(__idf_esp_driver_i2c PUBLIC ${mock}/include)
  add_library(__idf_nvs_flash ALIAS __idf_esp_driver_i2c)
  foreach(folder ${EXTRA_COMPONENT_DIRS} main)
    get_filename_component(folder ${folder} ABSOLUTE)
    get_filename_component(component ${folder} NAME)
    add_subdirectory(${folder} components/${component})
  endforeach()
  target_compile_options(__idf_main PRIVATE -std=gnu17 -Wall -Wextra -Werror)
  file(WRITE ${CMAKE_BINARY_DIR}/start.c
    "void app_main(void);\nint main(void)\n{\n    app_main();\n    return 0;\n}\n")
  add_executable(${name}.elf ${CMAKE_BINARY_DIR}/start.c)
  target_link_libraries(${name}.elf PRIVATE __idf_main)
endmacro()
