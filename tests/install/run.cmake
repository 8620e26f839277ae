# Installs the build into a fresh folder, then configures, builds and runs the consumer against it.
# cmake -DBUILD=<build> -DSOURCE=<consumer> -P run.cmake
set(prefix ${BUILD}/install-test/prefix)
set(consumer_build ${BUILD}/install-test/consumer)
file(REMOVE_RECURSE ${BUILD}/install-test)
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE out)
  if(code)
    message(FATAL_ERROR "${ARGN} failed:\n${out}")
  endif()
endfunction()
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${prefix})
run(${CMAKE_COMMAND} -S ${SOURCE} -B ${consumer_build} -G Ninja -DCMAKE_PREFIX_PATH=${prefix})
run(${CMAKE_COMMAND} --build ${consumer_build})
run(${consumer_build}/consumer)
run(${consumer_build}/swap_consumer)
if(EXISTS ${prefix}/bin/graze-render) # it finds its plug-in
  run(${prefix}/bin/graze-render --scene spheres --size 8 -o ${BUILD}/install-test/a.exr)
endif()
