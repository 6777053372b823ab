# What `cmake --install` copies: the program, and for find_package(dirt) the libraries core,
# backend_cpu and (where it is built) backend_gl with their headers under the same include paths.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

install(TARGETS dirt COMPONENT program)

set(headers ${CMAKE_INSTALL_INCLUDEDIR}/dirt)
set(folders core backend_cpu shaders/shared)
set(libraries core backend_cpu)
if(TARGET dirt_backend_gl)
    list(APPEND folders backend_gl)
    list(APPEND libraries backend_gl)
    set(gl_dependency "pkg_check_modules(EPOXY REQUIRED IMPORTED_TARGET epoxy)") # for dirtConfig
endif()
if(DIRT_DRACO AND TARGET draco::draco_static)
    set(draco_dependency "find_dependency(draco)") # for dirtConfig, like the next
endif()
if(DIRT_MESHOPT AND TARGET meshoptimizer::meshoptimizer)
    set(meshopt_dependency "find_dependency(meshoptimizer)")
endif()
foreach(folder ${folders})
    get_filename_component(parent ${folder} DIRECTORY)
    install(DIRECTORY ${folder} DESTINATION ${headers}/${parent} COMPONENT development
        FILES_MATCHING PATTERN *.h)
endforeach()

foreach(library ${libraries})
    set_target_properties(dirt_${library} PROPERTIES EXPORT_NAME ${library})
    install(TARGETS dirt_${library} EXPORT dirtTargets
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development
        INCLUDES DESTINATION ${headers})
endforeach()

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/dirt)
install(EXPORT dirtTargets NAMESPACE dirt:: DESTINATION ${package} COMPONENT development)
configure_package_config_file(cmake/dirtConfig.cmake.in ${PROJECT_BINARY_DIR}/dirtConfig.cmake
    INSTALL_DESTINATION ${package})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/dirtConfigVersion.cmake
    COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/dirtConfig.cmake ${PROJECT_BINARY_DIR}/dirtConfigVersion.cmake
    DESTINATION ${package} COMPONENT development)
