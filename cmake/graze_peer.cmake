# Other people's code: what is found of it, and the list of the peers (fuzz/peers/CMakeLists.txt).
include_guard()

# graze_find_peer(NAME PACKAGE HEADER [ALSO HEADERS...] [SUFFIXES...] [LIBRARIES...]): the target
# graze_peer::NAME, if the headers and the libraries are there; else says which of Debian's packages
# would bring them. find_package(PCL) would want VTK and all of PCL, so the parts that are used are
# looked for.
function(graze_find_peer name package header)
  cmake_parse_arguments(arg "" "" "ALSO;SUFFIXES;LIBRARIES" ${ARGN})
  string(TOUPPER ${name} upper)
  find_path(GRAZE_PEER_${upper}_INCLUDE NAMES ${header} PATH_SUFFIXES ${arg_SUFFIXES})
  set(found ${GRAZE_PEER_${upper}_INCLUDE})
  set(folders ${GRAZE_PEER_${upper}_INCLUDE})
  foreach(other ${arg_ALSO})
    string(MAKE_C_IDENTIFIER ${other} word)
    find_path(GRAZE_PEER_${upper}_${word} NAMES ${other} PATH_SUFFIXES ${arg_SUFFIXES})
    if(NOT GRAZE_PEER_${upper}_${word})
      set(found "")
    endif()
    list(APPEND folders ${GRAZE_PEER_${upper}_${word}})
  endforeach()
  set(libraries)
  foreach(library ${arg_LIBRARIES})
    find_library(GRAZE_PEER_${upper}_${library} NAMES ${library})
    if(NOT GRAZE_PEER_${upper}_${library})
      set(found "")
    endif()
    list(APPEND libraries ${GRAZE_PEER_${upper}_${library}})
  endforeach()
  if(NOT found)
    message(STATUS "${name} is missing (${package})")
    return()
  endif()
  add_library(graze_peer_${name} INTERFACE)
  add_library(graze_peer::${name} ALIAS graze_peer_${name})
  target_include_directories(graze_peer_${name} SYSTEM INTERFACE ${folders})
  target_link_libraries(graze_peer_${name} INTERFACE ${libraries})
endfunction()

# graze_peer(FOLDER NAME): FOLDER/NAME.hpp is on the list.
function(graze_peer folder name)
  set_property(GLOBAL APPEND PROPERTY graze_peers_${folder} ${name})
endfunction()

# graze_peer_registry(TARGET NAME...): peers::libraries() of the target are these.
function(graze_peer_registry target)
  set(declared "")
  set(named "")
  foreach(name ${ARGN})
    string(APPEND declared "std::vector<variant> ${name}_variants();\n")
    string(APPEND named "{\"${name}\", ${name}_variants()}, ")
    target_link_libraries(${target} PRIVATE graze_peer_${name}_driver)
  endforeach()
  file(CONFIGURE OUTPUT ${target}_registry.cpp CONTENT "#include <peers/library.hpp>
namespace graze::peers {
${declared}const std::vector<library>& libraries() {
  static const std::vector<library> all{${named}};
  return all;
}
} // namespace graze::peers
")
  target_sources(${target} PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/${target}_registry.cpp)
  target_link_libraries(${target} PRIVATE graze::peers)
endfunction()

# graze_peer_library(NAME PACKAGE HEADER [ALSO...] [SUFFIXES...] [LIBRARIES...] [OPTIONS flags...]):
# libraries/NAME.cpp is on the list. Where the library is found: its driver, and graze-adapter-NAME
# beside graze-fuzz unless GRAZE_ADAPTER_<NAME> is switched off. Own flags: the code of others is tried
# and measured as its users compile it.
function(graze_peer_library name package header)
  set_property(GLOBAL APPEND PROPERTY graze_peers_libraries ${name})
  if(GRAZE_FUZZING_ENGINE OR NOT (GRAZE_BUILD_TOOLS OR GRAZE_BUILD_BENCH))
    return()
  endif()
  cmake_parse_arguments(arg "" "" "OPTIONS" ${ARGN})
  graze_find_peer(${name} ${package} ${header} ${arg_UNPARSED_ARGUMENTS})
  if(NOT TARGET graze_peer::${name})
    set_property(GLOBAL APPEND PROPERTY graze_peers_missing ${name})
    return()
  endif()
  set_property(GLOBAL APPEND PROPERTY graze_peers_found ${name})
  add_library(graze_peer_${name}_driver STATIC EXCLUDE_FROM_ALL libraries/${name}.cpp)
  target_compile_options(graze_peer_${name}_driver PRIVATE $<$<CONFIG:Release>:-O3> -Wall -Wextra
                         -Wpedantic -Wno-maybe-uninitialized ${arg_OPTIONS})
  target_compile_definitions(graze_peer_${name}_driver PRIVATE NDEBUG)
  target_link_libraries(graze_peer_${name}_driver PUBLIC graze::peers PRIVATE graze_peer::${name})
  string(TOUPPER ${name} upper)
  option(GRAZE_ADAPTER_${upper} "graze-adapter-${name}, if ${package} is there" ON)
  if(GRAZE_BUILD_TOOLS AND GRAZE_ADAPTER_${upper})
    add_executable(graze-adapter-${name} adapter_program.cpp)
    target_compile_options(graze-adapter-${name} PRIVATE -Wall -Wextra -Wpedantic)
    target_compile_definitions(graze-adapter-${name} PRIVATE GRAZE_PROGRAM="graze-adapter-${name}")
    target_link_options(graze-adapter-${name} PRIVATE -Wl,--as-needed)
    graze_peer_registry(graze-adapter-${name} ${name})
    set_property(GLOBAL APPEND PROPERTY graze_adapters graze-adapter-${name})
  endif()
endfunction()

# graze_map_reader(NAME PACKAGE HEADER EXTENSIONS extensions... [ALSO...] [SUFFIXES...] [LIBRARIES...]):
# maps/NAME.cpp defines NAME_map(), which reads the voxels of such files. graze-adapter-NAME, which may be
# there by graze_peer_library, reads them where the library is found.
function(graze_map_reader name package header)
  cmake_parse_arguments(arg "" "" "EXTENSIONS;ALSO;SUFFIXES;LIBRARIES" ${ARGN})
  foreach(extension ${arg_EXTENSIONS})
    set_property(GLOBAL APPEND PROPERTY graze_map_extensions ${extension}:${name}:${package})
  endforeach()
  if(GRAZE_FUZZING_ENGINE OR NOT GRAZE_BUILD_TOOLS)
    return()
  endif()
  graze_find_peer(${name}_map ${package} ${header} ALSO ${arg_ALSO} SUFFIXES ${arg_SUFFIXES}
                  LIBRARIES ${arg_LIBRARIES})
  string(TOUPPER ${name} upper)
  option(GRAZE_ADAPTER_${upper} "graze-adapter-${name}, if ${package} is there" ON)
  if(NOT TARGET graze_peer::${name}_map OR NOT GRAZE_ADAPTER_${upper})
    return()
  endif()
  if(NOT TARGET graze-adapter-${name})
    add_executable(graze-adapter-${name} adapter_program.cpp)
    target_compile_options(graze-adapter-${name} PRIVATE -Wall -Wextra -Wpedantic)
    target_compile_definitions(graze-adapter-${name} PRIVATE GRAZE_PROGRAM="graze-adapter-${name}")
    target_link_options(graze-adapter-${name} PRIVATE -Wl,--as-needed)
    graze_peer_registry(graze-adapter-${name})
    set_property(GLOBAL APPEND PROPERTY graze_adapters graze-adapter-${name})
  endif()
  target_sources(graze-adapter-${name} PRIVATE maps/${name}.cpp maps/voxel_map.cpp)
  set_source_files_properties(maps/${name}.cpp PROPERTIES COMPILE_DEFINITIONS NDEBUG)
  set_source_files_properties(maps/voxel_map.cpp PROPERTIES COMPILE_OPTIONS -ffp-contract=off)
  string(JOIN " " extensions ${arg_EXTENSIONS})
  target_compile_definitions(graze-adapter-${name} PRIVATE GRAZE_MAP_READER=${name}_map
                             GRAZE_MAP_EXTENSIONS="${extensions}")
  target_link_libraries(graze-adapter-${name} PRIVATE graze_peer::${name}_map)
endfunction()

# graze_peers_end(): the target graze::peers (peers/list.hpp and the headers that are on it) and,
# where benchmarks may ask for them, graze::peer_libraries (all that were found).
function(graze_peers_end)
  set(includes "")
  set(lists "")
  foreach(folder paper2005 papers)
    get_property(names GLOBAL PROPERTY graze_peers_${folder})
    foreach(name ${names})
      string(APPEND includes "#include <peers/${folder}/${name}.hpp>\n")
    endforeach()
    list(JOIN names ", " names)
    string(APPEND lists "using ${folder} = list<${names}>;\n")
  endforeach()
  configure_file(list.hpp.in include/peers/list.hpp @ONLY)
  add_library(graze_peers INTERFACE)
  add_library(graze::peers ALIAS graze_peers)
  target_include_directories(graze_peers INTERFACE ${PROJECT_SOURCE_DIR}/fuzz
                             ${CMAKE_CURRENT_BINARY_DIR}/include)
  target_link_libraries(graze_peers INTERFACE graze::octree)

  get_property(found GLOBAL PROPERTY graze_peers_found)
  get_property(missing GLOBAL PROPERTY graze_peers_missing)
  add_library(graze_peer_libraries STATIC EXCLUDE_FROM_ALL)
  add_library(graze::peer_libraries ALIAS graze_peer_libraries)
  graze_peer_registry(graze_peer_libraries ${found})
  list(JOIN found " " found)
  list(JOIN missing " " missing)
  if(missing STREQUAL "")
    set(missing none)
  endif()
  target_compile_definitions(graze_peer_libraries PUBLIC GRAZE_PEERS_MISSING=" ${missing}")
  message(STATUS "fuzz/peers: found: ${found}; missing: ${missing}")
endfunction()
