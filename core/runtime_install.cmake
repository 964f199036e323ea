# What a game links: cmake --install BUILD --component runtime, then find_package(bosk) and link Bosk::runtime.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(runtime_headers
  core/base/error.h
  core/package/reader.h core/package/tree_model.h
  core/render/billboard_geometry.h core/render/draw_list.h core/render/forest.h core/render/prepared_tree.h
  core/render/view_blend.h core/render/view_cone.h)

add_library(bosk_runtime_and_draw_list INTERFACE)
target_link_libraries(bosk_runtime_and_draw_list INTERFACE bosk_runtime bosk_draw_list)
target_compile_features(bosk_runtime_and_draw_list INTERFACE cxx_std_20)
set_target_properties(bosk_runtime_and_draw_list PROPERTIES EXPORT_NAME runtime)
set_target_properties(bosk_runtime PROPERTIES EXPORT_NAME reader)
set_target_properties(bosk_draw_list PROPERTIES EXPORT_NAME draw_list)

set(config_folder ${CMAKE_INSTALL_LIBDIR}/cmake/bosk)
install(TARGETS bosk_runtime_and_draw_list bosk_runtime bosk_draw_list EXPORT bosk COMPONENT runtime
  INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/bosk)
install(EXPORT bosk NAMESPACE Bosk:: FILE bosk-targets.cmake DESTINATION ${config_folder} COMPONENT runtime)
foreach(header ${runtime_headers})
  cmake_path(GET header PARENT_PATH folder)
  install(FILES ${CMAKE_SOURCE_DIR}/${header} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/bosk/${folder} COMPONENT runtime)
endforeach()

configure_package_config_file(${CMAKE_SOURCE_DIR}/third_party/cmake/bosk-config.cmake.in
  ${CMAKE_CURRENT_BINARY_DIR}/bosk-config.cmake INSTALL_DESTINATION ${config_folder})
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/bosk-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/bosk-config.cmake ${CMAKE_CURRENT_BINARY_DIR}/bosk-config-version.cmake
  DESTINATION ${config_folder} COMPONENT runtime)
