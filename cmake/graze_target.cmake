# Every target of Graze is made through these helpers, so that the flags that the numerics depend on
# are written once.

# graze_flags(TARGET): -frounding-math stops constant folding across a change of mode (it is not
# enough alone: GCC still merges common subexpressions, which the barriers in the backends stop);
# -ffp-contract=off keeps a*b+c two roundings.
function(graze_flags target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow
                         -frounding-math -ffp-contract=off)
  if(GRAZE_WERROR)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
endfunction()

# graze_library(NAME [SOURCES...] [FOLDERS folder...]): the library target graze_NAME, alias graze::NAME,
# with headers in include/, or in that of each folder; where there is none, beside the sources. Header-only
# when no source is given.
function(graze_library name)
  cmake_parse_arguments(arg "" "" "FOLDERS" ${ARGN})
  if(arg_UNPARSED_ARGUMENTS)
    set(kind PUBLIC)
    add_library(graze_${name} STATIC ${arg_UNPARSED_ARGUMENTS})
    graze_flags(graze_${name})
  else()
    set(kind INTERFACE)
    add_library(graze_${name} INTERFACE)
    target_compile_features(graze_${name} INTERFACE cxx_std_20)
  endif()
  set(headers include)
  if(NOT IS_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/include)
    set(headers .)
  endif()
  if(arg_FOLDERS)
    list(TRANSFORM arg_FOLDERS APPEND /include OUTPUT_VARIABLE headers)
  endif()
  foreach(folder IN LISTS headers)
    target_include_directories(graze_${name} ${kind} $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/${folder}>)
  endforeach()
  target_include_directories(graze_${name} ${kind} $<INSTALL_INTERFACE:include>)
  add_library(graze::${name} ALIAS graze_${name})
  set_target_properties(graze_${name} PROPERTIES EXPORT_NAME ${name})
endfunction()

# What a path's instructions are called by the compiler, once for the whole project.
if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|amd64)$")
  set(graze_paths baseline avx2 avx512)
  set(graze_path_type_baseline sse2)
else()
  set(graze_paths baseline)
  set(graze_path_type_baseline portable)
endif()
set(graze_path_type_avx2 avx2)
set(graze_path_type_avx512 avx512)
set(graze_path_type_portable portable)
set(graze_path_flags_avx2 -mavx2 -mfma -mpopcnt)
set(graze_path_flags_avx512 -mavx512f -mavx512dq -mbmi -mbmi2 -mpopcnt -mprefer-vector-width=512)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU") # gcc bug 105593: its own header's undefined operands
  list(APPEND graze_path_flags_avx512 -Wno-maybe-uninitialized)
endif()

# graze_paths(TARGET SOURCE [PATHS path...] [FLAGS flag...]): SOURCE becomes a part of TARGET once for
# each path (or for those named), compiled for its instructions: graze/batch/per_path.hpp. The objects
# are named PATH_SOURCE, so that tests find them.
function(graze_paths target source)
  cmake_parse_arguments(arg "" "" "PATHS;FLAGS" ${ARGN})
  if(NOT arg_PATHS)
    set(arg_PATHS ${graze_paths})
  endif()
  get_filename_component(source ${source} ABSOLUTE)
  file(RELATIVE_PATH place ${PROJECT_SOURCE_DIR} ${source})
  get_filename_component(folder ${place} DIRECTORY)
  get_filename_component(name ${place} NAME)
  foreach(path IN LISTS arg_PATHS)
    set(made ${PROJECT_BINARY_DIR}/paths/${folder}/${path}_${name})
    file(CONFIGURE OUTPUT ${made} @ONLY CONTENT
"#define GRAZE_PATH ${path}
#define GRAZE_PATH_TYPE ${graze_path_type_${path}}
#define GRAZE_PATH_HEADER <graze/batch/${graze_path_type_${path}}.hpp>
#include \"${source}\"
")
    target_sources(${target} PRIVATE ${made})
    set_source_files_properties(${made} PROPERTIES
      COMPILE_OPTIONS "${arg_FLAGS};${graze_path_flags_${path}}" OBJECT_DEPENDS ${source})
  endforeach()
endfunction()

# graze_program(NAME SOURCES...): an executable in bin/.
function(graze_program name)
  add_executable(${name} ${ARGN})
  graze_flags(${name})
endfunction()

# graze_test(NAME SOURCES... LIBS targets...): a Catch2 executable; every TEST_CASE is a ctest entry.
# One that prints "graze: skipped, ..." (the processor lacks what it tests) counts as skipped; one that
# ends without an assertion otherwise fails. SECONDS is how long each may take, GRAZE_TEST_SECONDS if not
# given: several times what the slowest takes on a slow machine beside another, so that a hang costs little
# more.
set(GRAZE_TEST_SECONDS 60 CACHE STRING "Seconds that a test may take, if its program names no other time")
function(graze_test name)
  cmake_parse_arguments(arg "" "SECONDS" "LIBS" ${ARGN})
  if(NOT arg_SECONDS)
    set(arg_SECONDS ${GRAZE_TEST_SECONDS})
  endif()
  graze_program(${name} ${arg_UNPARSED_ARGUMENTS})
  target_link_libraries(${name} PRIVATE graze_catch_main ${arg_LIBS})
  catch_discover_tests(${name} TEST_PREFIX "" EXTRA_ARGS --warn NoAssertions PROPERTIES
                        TIMEOUT ${arg_SECONDS}
                        SKIP_REGULAR_EXPRESSION "graze: skipped,")
endfunction()
