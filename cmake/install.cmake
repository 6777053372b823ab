# What `cmake --install` copies: the program, and for find_package(dirt) the libraries core and
# backend_cpu with their headers under the same include paths.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

install(TARGETS dirt COMPONENT program)

set(headers ${CMAKE_INSTALL_INCLUDEDIR}/dirt)
foreach(folder core backend_cpu shaders/shared)
    get_filename_component(parent ${folder} DIRECTORY)
    install(DIRECTORY ${folder} DESTINATION ${headers}/${parent} COMPONENT development
        FILES_MATCHING PATTERN *.h)
endforeach()

set_target_properties(dirt_core PROPERTIES EXPORT_NAME core)
set_target_properties(dirt_backend_cpu PROPERTIES EXPORT_NAME backend_cpu)
install(TARGETS dirt_core dirt_backend_cpu EXPORT dirtTargets
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development
    INCLUDES DESTINATION ${headers})

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/dirt)
install(EXPORT dirtTargets NAMESPACE dirt:: DESTINATION ${package} COMPONENT development)
configure_package_config_file(cmake/dirtConfig.cmake.in ${PROJECT_BINARY_DIR}/dirtConfig.cmake
    INSTALL_DESTINATION ${package})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/dirtConfigVersion.cmake
    COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/dirtConfig.cmake ${PROJECT_BINARY_DIR}/dirtConfigVersion.cmake
    DESTINATION ${package} COMPONENT development)
