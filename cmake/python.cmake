# The module wythe/_wythe of the Python package, for Debian's own interpreter: another python3 may stand before
# it on the PATH, without Debian's packages. setup.py builds this target and takes the file from there. With
# build/<preset>/python on PYTHONPATH the package works without being installed.
set(WYTHE_PYTHON_PROGRAM /usr/bin/python3 CACHE FILEPATH "interpreter the module is built for")
set(Python_EXECUTABLE ${WYTHE_PYTHON_PROGRAM})
find_package(Python COMPONENTS Interpreter Development.Module)
find_package(pybind11 QUIET)
if(NOT Python_FOUND OR NOT pybind11_FOUND)
  message(STATUS "no Python package: ${WYTHE_PYTHON_PROGRAM} with its headers and pybind11 are not all here")
  return()
endif()
pybind11_add_module(wythe_python MODULE NO_EXTRAS python/module.cpp $<TARGET_OBJECTS:wythe_interface>)
set(WYTHE_PYTHON_PACKAGE ${CMAKE_BINARY_DIR}/python/wythe)
set_target_properties(wythe_python PROPERTIES OUTPUT_NAME _wythe
  LIBRARY_OUTPUT_DIRECTORY ${WYTHE_PYTHON_PACKAGE})
target_link_libraries(wythe_python PRIVATE wythe wythe_warnings)
file(GLOB WYTHE_PYTHON_FILES CONFIGURE_DEPENDS python/wythe/*.py python/wythe/*.pyi python/wythe/py.typed)
file(MAKE_DIRECTORY ${WYTHE_PYTHON_PACKAGE})
foreach(file ${WYTHE_PYTHON_FILES})
  cmake_path(GET file FILENAME name)
  file(CREATE_LINK ${file} ${WYTHE_PYTHON_PACKAGE}/${name} SYMBOLIC)
endforeach()
