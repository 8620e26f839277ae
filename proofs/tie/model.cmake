# The model as a program, where coqc and OCaml are, and its answers to lines made anew.
find_program(GRAZE_COQC coqc)
find_program(GRAZE_OCAMLFIND ocamlfind)
if(NOT GRAZE_COQC OR NOT GRAZE_OCAMLFIND)
  # replaying vectors.txt needs neither
  set(GRAZE_COQC FALSE)
  add_test(NAME "proofs.tie: vectors.txt is the model's"
           COMMAND sh -c "echo graze: skipped, coqc and ocamlfind are not both installed")
  set_tests_properties("proofs.tie: vectors.txt is the model's" PROPERTIES
                       SKIP_REGULAR_EXPRESSION "graze: skipped,")
  return()
endif()

set(model ${tie_build_dir}/model)
set(graze_model ${model}/graze-model)
set(model_answers ${tie_build_dir}/answers.txt)
set(coq_sources)
set(compile)
foreach(name Model Model_descent Negation Bounds Never_miss Nearest Exact_integer Extraction)
  list(APPEND coq_sources ${PROJECT_SOURCE_DIR}/proofs/coq/${name}.v)
  list(APPEND compile COMMAND ${GRAZE_COQC} -q -Q . Graze ${name}.v)
endforeach()
set(ocaml_sources ${tie_source_dir}/zarith_bits.ml ${tie_source_dir}/graze_model.ml)
file(MAKE_DIRECTORY ${model})
add_custom_command(
  OUTPUT ${model}/model.ml
  COMMAND ${CMAKE_COMMAND} -E copy ${coq_sources} ${model}
  ${compile}
  DEPENDS ${coq_sources} WORKING_DIRECTORY ${model}
  COMMENT "proofs/tie: the model, extracted" VERBATIM)
add_custom_command(
  OUTPUT ${graze_model}
  COMMAND ${CMAKE_COMMAND} -E copy ${ocaml_sources} ${model}
  COMMAND ${GRAZE_OCAMLFIND} ocamlopt -O3 -w -a -package zarith -linkpkg zarith_bits.ml model.mli
          model.ml graze_model.ml -o ${graze_model}
  DEPENDS ${ocaml_sources} ${model}/model.ml WORKING_DIRECTORY ${model}
  COMMENT "proofs/tie: graze-model" VERBATIM)
add_custom_target(tie_model ALL DEPENDS ${graze_model})

graze_program(tie_generate generate.cpp)
target_link_libraries(tie_generate PRIVATE graze::fuzz_core)

add_test(NAME "proofs.tie: vectors.txt is the model's"
         COMMAND ${CMAKE_COMMAND} -DMODEL=${graze_model} -DVECTORS=${vectors}
                 -DOUT=${tie_build_dir}/vectors.txt -P ${tie_source_dir}/same_vectors.cmake)
set_tests_properties("proofs.tie: vectors.txt is the model's" PROPERTIES TIMEOUT 300)
add_test(NAME "proofs.tie: the model answers"
         COMMAND ${CMAKE_COMMAND} -DGENERATE=$<TARGET_FILE:tie_generate> -DMODEL=${graze_model}
                 -DOUT=${model_answers} -P ${tie_source_dir}/answer.cmake)
set_tests_properties("proofs.tie: the model answers" PROPERTIES
                     FIXTURES_SETUP tie_answers TIMEOUT 7200)
