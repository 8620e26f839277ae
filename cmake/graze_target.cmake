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

# graze_library(NAME [SOURCES...]): the library target graze_NAME, alias graze::NAME, with headers
# in include/. Header-only when no source is given.
function(graze_library name)
  if(ARGN)
    add_library(graze_${name} STATIC ${ARGN})
    graze_flags(graze_${name})
    target_include_directories(graze_${name} PUBLIC
      $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:include>)
  else()
    add_library(graze_${name} INTERFACE)
    target_compile_features(graze_${name} INTERFACE cxx_std_20)
    target_include_directories(graze_${name} INTERFACE
      $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:include>)
  endif()
  add_library(graze::${name} ALIAS graze_${name})
  set_target_properties(graze_${name} PROPERTIES EXPORT_NAME ${name})
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
