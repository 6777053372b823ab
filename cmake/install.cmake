# What `cmake --install` copies: the program with its licence and scenes; and for find_package(dirt)
# and pkg-config the libraries core, backend_cpu and (where it is built) backend_gl. Their headers are
# included as <dirt/core/...>, and include each other so: a program may have a core/grid/grid.h of its
# own.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

install(TARGETS dirt COMPONENT program)
install(FILES LICENSE README.md CITATION.cff DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
# Their geometry, 170 MB, is left to `dirt generate`.
install(DIRECTORY scenes/ DESTINATION ${CMAKE_INSTALL_DATADIR}/dirt/scenes COMPONENT program
    FILES_MATCHING PATTERN *.scene PATTERN generate EXCLUDE PATTERN generated EXCLUDE)
install(DIRECTORY examples DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT development)

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
        FILES_MATCHING PATTERN *.h PATTERN *-inl.h EXCLUDE)
endforeach()
install(CODE "set(headers \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${headers}\")
include(\"${PROJECT_SOURCE_DIR}/cmake/prefix_includes.cmake\")" COMPONENT development)

foreach(library ${libraries})
    set_target_properties(dirt_${library} PROPERTIES EXPORT_NAME ${library})
    install(TARGETS dirt_${library} EXPORT dirtTargets
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development
        INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
endforeach()

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/dirt)
install(EXPORT dirtTargets NAMESPACE dirt:: DESTINATION ${package} COMPONENT development)
configure_package_config_file(cmake/dirtConfig.cmake.in ${PROJECT_BINARY_DIR}/dirtConfig.cmake
    INSTALL_DESTINATION ${package})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/dirtConfigVersion.cmake
    COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/dirtConfig.cmake ${PROJECT_BINARY_DIR}/dirtConfigVersion.cmake
    DESTINATION ${package} COMPONENT development)

# For builds without CMake.
set(pkg_config_requires "OpenImageIO pugixml libhwy libpng")
set(pkg_config_libraries "-ldirt_backend_cpu")
if(TARGET dirt_backend_gl)
    string(APPEND pkg_config_requires " epoxy")
    string(PREPEND pkg_config_libraries "-ldirt_backend_gl ")
endif()
string(APPEND pkg_config_libraries " -ldirt_core")
if(draco_dependency)
    string(APPEND pkg_config_libraries " -ldraco")
endif()
if(meshopt_dependency)
    string(APPEND pkg_config_libraries " -lmeshoptimizer")
endif()
configure_file(cmake/dirt.pc.in ${PROJECT_BINARY_DIR}/dirt.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/dirt.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
    COMPONENT development)
