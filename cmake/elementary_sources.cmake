# The C sources of CORE-MATH and CRlibm, pinned by SHA-256 in cmake/sources/Cargo.lock: sets
# GRAZE_CORE_MATH_DIR and, with GRAZE_WITH_CRLIBM, GRAZE_CRLIBM_DIR. They are fetched once a build
# folder; a later configure needs no network.
set(CORE_MATH_SOURCE_DIR "" CACHE PATH
    "CORE-MATH's sources (the folder that holds src/binary64/exp/exp.c); fetched if empty")
set(CRLIBM_SOURCE_DIR "" CACHE PATH
    "CRlibm's sources (the folder that holds crlibm.h); fetched if empty")
option(GRAZE_WITH_CRLIBM "Build CRlibm (LGPL), the second implementation of the functions" ON)

set(graze_sources_dir "${PROJECT_BINARY_DIR}/_sources")

# Fetches all crates of the lock file into ${graze_sources_dir}. Cargo checks their hashes. The
# folder appears in one step, so that an interrupted download leaves none behind.
function(graze_fetch_sources)
  if(EXISTS "${graze_sources_dir}")
    return()
  endif()
  set(remedy "Install cargo 1.85 or newer (Debian 12: the package cargo-web) and allow it to reach \
its registry, or set -DCORE_MATH_SOURCE_DIR=... and -DCRLIBM_SOURCE_DIR=... to unpacked sources \
(-DGRAZE_WITH_CRLIBM=OFF needs only the first).")
  find_program(GRAZE_CARGO cargo HINTS "$ENV{HOME}/.cargo/bin")
  if(NOT GRAZE_CARGO)
    message(FATAL_ERROR "cargo was not found; it fetches the sources of CORE-MATH and CRlibm. ${remedy}")
  endif()
  message(STATUS "Fetching CORE-MATH and CRlibm")
  file(REMOVE_RECURSE "${graze_sources_dir}.part")
  execute_process(
    COMMAND "${GRAZE_CARGO}" vendor --quiet --locked --versioned-dirs
            --manifest-path "${PROJECT_SOURCE_DIR}/cmake/sources/Cargo.toml"
            "${graze_sources_dir}.part"
    WORKING_DIRECTORY "${PROJECT_BINARY_DIR}" RESULT_VARIABLE code OUTPUT_VARIABLE out
    ERROR_VARIABLE errors)
  if(code)
    message(FATAL_ERROR "cargo could not fetch CORE-MATH and CRlibm:\n${errors}\n${remedy}")
  endif()
  file(RENAME "${graze_sources_dir}.part" "${graze_sources_dir}")
endfunction()

# graze_find_sources(VARIABLE GIVEN FETCHED PROBE): the folder given by the user, else the fetched
# one; PROBE must be in it.
function(graze_find_sources variable given fetched probe)
  if(${given})
    set(folder "${${given}}")
    if(NOT EXISTS "${folder}/${probe}")
      message(FATAL_ERROR "${given}=${folder} does not hold ${probe}")
    endif()
  else()
    graze_fetch_sources()
    set(folder "${graze_sources_dir}/${fetched}")
    if(NOT EXISTS "${folder}/${probe}")
      message(FATAL_ERROR "${folder} does not hold ${probe}; remove ${graze_sources_dir}, "
                          "to fetch it again, or set -D${given}=...")
    endif()
  endif()
  set(${variable} "${folder}" PARENT_SCOPE)
endfunction()

graze_find_sources(GRAZE_CORE_MATH_DIR CORE_MATH_SOURCE_DIR core-math-sys-1.4.0/vendor
                   src/binary64/exp/exp.c)
if(GRAZE_WITH_CRLIBM)
  graze_find_sources(GRAZE_CRLIBM_DIR CRLIBM_SOURCE_DIR crlibm-0.2.0/crlibm crlibm.h)
endif()
