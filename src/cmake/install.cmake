# Installs the library, its headers and program, and the package that find_package(eliminant) reads.
include(CMakePackageConfigHelpers)
set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/eliminant")

install(TARGETS eliminant EXPORT eliminant-targets)
if(TARGET eliminant_program)
  install(TARGETS eliminant_program)
endif()
install(DIRECTORY include/eliminant DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}" FILES_MATCHING PATTERN "*.hpp")
install(EXPORT eliminant-targets NAMESPACE eliminant:: DESTINATION "${package_dir}")

configure_package_config_file(src/cmake/eliminant-config.cmake.in eliminant-config.cmake
  INSTALL_DESTINATION "${package_dir}")
write_basic_package_version_file(eliminant-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES
  "${CMAKE_CURRENT_BINARY_DIR}/eliminant-config.cmake"
  "${CMAKE_CURRENT_BINARY_DIR}/eliminant-config-version.cmake"
  src/cmake/FindGMP.cmake
  DESTINATION "${package_dir}")
