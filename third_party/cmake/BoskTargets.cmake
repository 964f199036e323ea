# How every target of the project is built: one place for warnings, instruction set and sanitizers.

add_library(bosk_flags INTERFACE)
target_compile_options(bosk_flags INTERFACE -Wall -Wextra -Wshadow -Wconversion)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  # False alarms: on "text" + std::string (GCC bug 105651), on members of a copied Recipe
  target_compile_options(bosk_flags INTERFACE -Wno-restrict -Wno-maybe-uninitialized)
endif()
target_include_directories(bosk_flags INTERFACE ${CMAKE_SOURCE_DIR})
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  target_compile_options(bosk_flags INTERFACE -march=x86-64-v2)
endif()
if(BOSK_WARNINGS_AS_ERRORS)
  target_compile_options(bosk_flags INTERFACE -Werror)
endif()
if(BOSK_SANITIZE)
  target_compile_options(bosk_flags INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=undefined
                                              -fno-omit-frame-pointer)
  target_link_options(bosk_flags INTERFACE -fsanitize=address,undefined)
endif()

# bosk_folder(NAME SOURCES a.cpp ... [DEPENDS targets...]): the static library bosk_NAME of one folder of core/.
function(bosk_folder name)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS" ${ARGN})
  add_library(bosk_${name} STATIC ${ARG_SOURCES})
  target_link_libraries(bosk_${name} PUBLIC $<BUILD_INTERFACE:bosk_flags> ${ARG_DEPENDS})
endfunction()

# bosk_test(NAME SOURCES a_test.cpp ... DEPENDS targets...): one GoogleTest program, its tests named NAME.*.
function(bosk_test name)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS" ${ARGN})
  add_executable(${name}_tests ${ARG_SOURCES})
  target_link_libraries(${name}_tests PRIVATE bosk_flags ${ARG_DEPENDS} GTest::gtest_main GTest::gmock)
  gtest_discover_tests(${name}_tests TEST_PREFIX ${name}. DISCOVERY_TIMEOUT 60 PROPERTIES TIMEOUT 600)
endfunction()
