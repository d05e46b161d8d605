# SPDX-License-Identifier: Apache-2.0
# What `cmake --install build` puts where, and how an embedder finds it:
# sozai.pc for pkg-config, sozaiConfig.cmake for find_package. Nothing links
# sozai.so, so it lives in a folder of its own below the libraries. The command
# is installed where it is built, in hosts/cli. Included when the plugin's and
# the colour service's targets exist.
include(CMakePackageConfigHelpers)

set(plugin_dir ${CMAKE_INSTALL_LIBDIR}/sozai)
set(config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/sozai)
set(pkgconfig_dir ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

install(FILES api/sozai.h api/sozai_colour.h TYPE INCLUDE)
# README.md's links into docs/ lead somewhere from there.
set(top_pages README.md CHANGELOG.md CONTRIBUTING.md SECURITY.md)
install(FILES LICENSE ${top_pages} TYPE DOC)
install(DIRECTORY docs TYPE DOC)
install(FILES docs/example/embed.c DESTINATION ${CMAKE_INSTALL_DOCDIR}/example)
# Those into the sources do not; after the headers, which some of them lead to then.
install(CODE "set(SOZAI_SOURCE \"${PROJECT_SOURCE_DIR}\")
  set(SOZAI_TOP_PAGES \"${top_pages}\")
  set(DOCDIR \"${CMAKE_INSTALL_DOCDIR}\")
  set(INCLUDEDIR \"${CMAKE_INSTALL_INCLUDEDIR}\")")
install(SCRIPT cmake/InstallDocs.cmake)

install(TARGETS sozai LIBRARY DESTINATION ${plugin_dir})
if(TARGET sozai-colour)
  # Beside sozai.so, which looks for it there; the config likewise beside it.
  install(TARGETS sozai-colour LIBRARY DESTINATION ${plugin_dir})
  install(FILES $<TARGET_FILE_DIR:sozai-colour>/sozai.ocio DESTINATION ${plugin_dir})
endif()
if(TARGET sozai-images)
  install(TARGETS sozai-images LIBRARY DESTINATION ${plugin_dir}) # sozai-colour.so looks beside itself
endif()

install(TARGETS sozai_api EXPORT sozai-targets)
install(EXPORT sozai-targets FILE sozaiTargets.cmake NAMESPACE sozai:: DESTINATION ${config_dir})
configure_package_config_file(cmake/sozaiConfig.cmake.in
  ${PROJECT_BINARY_DIR}/package/sozaiConfig.cmake
  INSTALL_DESTINATION ${config_dir} PATH_VARS plugin_dir NO_CHECK_REQUIRED_COMPONENTS_MACRO)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/package/sozaiConfigVersion.cmake
  COMPATIBILITY SameMajorVersion)
install(FILES
  ${PROJECT_BINARY_DIR}/package/sozaiConfig.cmake
  ${PROJECT_BINARY_DIR}/package/sozaiConfigVersion.cmake
  DESTINATION ${config_dir})

# The way from the .pc file up to the prefix, so that an installed tree may be
# moved. Where the libraries' folder was given as an absolute path it cannot be.
if(IS_ABSOLUTE ${CMAKE_INSTALL_LIBDIR})
  set(pc_prefix ${CMAKE_INSTALL_PREFIX})
else()
  file(RELATIVE_PATH pc_prefix ${CMAKE_INSTALL_PREFIX}/${pkgconfig_dir} ${CMAKE_INSTALL_PREFIX})
  string(REGEX REPLACE "/$" "" pc_prefix "\${pcfiledir}/${pc_prefix}")
endif()
foreach(name INCLUDEDIR LIBDIR)
  if(IS_ABSOLUTE ${CMAKE_INSTALL_${name}})
    set(pc_${name} ${CMAKE_INSTALL_${name}})
  else()
    set(pc_${name} "\${prefix}/${CMAKE_INSTALL_${name}}")
  endif()
endforeach()
configure_file(cmake/sozai.pc.in ${PROJECT_BINARY_DIR}/package/sozai.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/package/sozai.pc DESTINATION ${pkgconfig_dir})
