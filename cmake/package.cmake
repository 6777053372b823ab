# Debian packages, made by `cpack` in the build folder: `dirt`, the program with its scenes, and
# `libdirt-dev`, the libraries with their headers. CONTRIBUTING.md says how they are tried.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME dirt)
set(CPACK_PACKAGE_CONTACT "The dirt authors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL program development)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME dirt)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS libegl1) # opened at run time, for --backend gl

# What dirtConfig.cmake and dirt.pc ask for.
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libdirt-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(development libglm-dev libhwy-dev libopenimageio-dev libpng-dev libpugixml-dev pkg-config)
if(TARGET dirt_backend_gl)
    list(APPEND development libepoxy-dev)
endif()
if(draco_dependency)
    list(APPEND development libdraco-dev)
endif()
if(meshopt_dependency)
    list(APPEND development libmeshoptimizer-dev)
endif()
list(JOIN development ", " CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS)
include(CPack)
