# The code must give the model's answers whatever the flags: the barriers of the backends hold
# without -frounding-math and with contraction allowed.

# graze_tie_variant(ID COMPILER PATHS FLAGS...)
function(graze_tie_variant id compiler paths)
  if(NOT compiler IN_LIST compiler_names)
    return()
  endif()
  graze_tie_program(${id} ${path_of_${compiler}} ${paths} ${ARGN})
  set(program ${tie_build_dir}/programs/${id})
  list(JOIN ARGN " " flags)
  set(label "(${compiler} ${flags})")
  add_test(NAME "proofs.tie: replay ${label}" COMMAND ${program} ${vectors})
  if(x86_64)
    add_test(NAME "proofs.tie: replay, FTZ and DAZ set outside of the scopes ${label}"
             COMMAND ${program} --flush ${vectors})
  endif()
  if(GRAZE_COQC)
    add_test(NAME "proofs.tie: the model's answers ${label}" COMMAND ${program} ${model_answers})
    set_tests_properties("proofs.tie: the model's answers ${label}" PROPERTIES
                         FIXTURES_REQUIRED tie_answers TIMEOUT 1200)
  endif()
endfunction()

set(native -march=native -ffp-contract=fast)
graze_tie_variant(gxx_o0 g++ none -O0)
graze_tie_variant(gxx_o2 g++ all -O2)
graze_tie_variant(gxx_o2_rounding g++ none -O2 -frounding-math)
graze_tie_variant(gxx_o3_native g++ all -O3 ${native})
graze_tie_variant(gxx_o3_native_rounding g++ none -O3 -march=native -frounding-math)
graze_tie_variant(clang_o0 clang++ none -O0)
graze_tie_variant(clang_o2 clang++ all -O2)
graze_tie_variant(clang_o2_rounding clang++ none -O2 -frounding-math)
graze_tie_variant(clang_o3_native clang++ all -O3 ${native})
# clang tells the headers nothing of these, so that they cannot be refused: the code must hold.
graze_tie_variant(clang_o2_associative clang++ all -O2 -fassociative-math -fno-signed-zeros
                  -fno-trapping-math -freciprocal-math)
