# GENERATE | MODEL --quick > OUT, for GRAZE_TEST_INPUTS lines (20000 by default).
set(count 20000)
if(DEFINED ENV{GRAZE_TEST_INPUTS})
  set(count $ENV{GRAZE_TEST_INPUTS})
endif()
execute_process(COMMAND ${GENERATE} ${count} 7 COMMAND ${MODEL} --quick OUTPUT_FILE ${OUT}
                RESULTS_VARIABLE codes)
if(NOT codes STREQUAL "0;0")
  message(FATAL_ERROR "the model gives no answers: ${codes}")
endif()
message(STATUS "${count} lines answered")
