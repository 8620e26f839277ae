# The lines committed are what the model answers today.
execute_process(COMMAND ${MODEL} INPUT_FILE ${VECTORS} OUTPUT_FILE ${OUT} RESULT_VARIABLE code)
if(code)
  message(FATAL_ERROR "the model gives no answers: ${code}")
endif()
execute_process(COMMAND ${CMAKE_COMMAND} -E compare_files ${VECTORS} ${OUT} RESULT_VARIABLE code)
if(code)
  message(FATAL_ERROR "${VECTORS} holds other answers than the model gives: ${OUT}")
endif()
