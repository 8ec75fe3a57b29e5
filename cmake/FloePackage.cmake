# Debian packages by CPack: floe (the program), libfloe-dev (the library), python3-floe.
#   cmake --build build/release && cpack --config build/release/CPackConfig.cmake -B build/packages
set(CPACK_PACKAGE_CONTACT "floe developers <floe@example.org>" CACHE STRING "Maintainer of packages")
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME floe)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # every package has its own, the first line
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE
  GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_COMPONENTS_ALL program development)
if(TARGET floe_python)
  list(APPEND CPACK_COMPONENTS_ALL python)
endif()
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME floe)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION "hydroelastic response of very large floating structures
How a very large floating structure (an airport, a field of solar panels, an
ice floe) bends in waves. The structure is a thin elastic plate of any outline
on water of any constant depth; plate and water are solved together, in the
frequency domain, to first order. Fast operators take it to hundreds of
thousands of nodes on a workstation.

This package has the program.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libfloe-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libeigen3-dev (>= 3.4), libfftw3-dev, \
libopenblas-dev | liblapack-dev, libsuitesparse-dev, libnetcdf-dev, zlib1g-dev, libfmt-dev")
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION
  "hydroelastic response of very large floating structures, library
How a very large floating structure bends in waves: Mindlin plate, boundary
elements of higher order for the water, fast operators.

This package has the static C++ library, its headers and CMake package.")

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-floe)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
if(TARGET floe_python)
  math(EXPR next_python "${Python3_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3 (>= 3.${Python3_VERSION_MINOR}), \
python3 (<< 3.${next_python}), python3-numpy, python3-tomli-w")
endif()
set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS python3-xarray)
set(CPACK_DEBIAN_PYTHON_DESCRIPTION
  "hydroelastic response of very large floating structures, Python module
How a very large floating structure bends in waves: cases as dictionaries or
files, results as numpy arrays or an xarray data set.

This package has the Python module.")

# What every package of Debian has: copyright and changelog
set(packaging ${CMAKE_CURRENT_BINARY_DIR}/packaging)
configure_file(packaging/changelog.in ${packaging}/changelog @ONLY)
execute_process(COMMAND gzip -9nc ${packaging}/changelog OUTPUT_FILE ${packaging}/changelog.gz
  COMMAND_ERROR_IS_FATAL ANY)
foreach(component ${CPACK_COMPONENTS_ALL})
  string(TOUPPER ${component} upper)
  install(FILES packaging/copyright ${packaging}/changelog.gz
    DESTINATION share/doc/${CPACK_DEBIAN_${upper}_PACKAGE_NAME} COMPONENT ${component})
endforeach()
install(FILES README.md CHANGELOG.md DESTINATION share/doc/floe)
install(DIRECTORY docs DESTINATION share/doc/floe)
install(DIRECTORY cases DESTINATION share/doc/floe/examples PATTERN "*.out" EXCLUDE)
include(CPack)
