# Mutants: the code with one fault each, which vectors.txt must catch. A fault is made of the
# shipped header by replacing a text that must stand in it exactly once, so that none can rot.

set(mutants ${tie_build_dir}/mutants)
set(mutant_compiler "${GRAZE_TEST_GXX}")

# graze_mutant(ID "what is wrong" FILE header FROM text TO text [PATHS baseline]
#              [COMPILER path] [FLAGS ...] [REPLAY argument])
function(graze_mutant id title)
  cmake_parse_arguments(PARSE_ARGV 2 arg "" "FILE;FROM;TO;COMPILER;PATHS;REPLAY" "FLAGS")
  set(compiler ${mutant_compiler})
  if(arg_COMPILER)
    set(compiler ${arg_COMPILER})
  endif()
  if(NOT arg_FLAGS)
    set(arg_FLAGS -O1 -DGRAZE_TIE_UPWARD_ALONE)
  endif()
  if(NOT arg_PATHS)
    set(arg_PATHS none)
  endif()
  string(REGEX REPLACE "^.*/include/" "" header ${arg_FILE})
  set(original ${PROJECT_SOURCE_DIR}/${arg_FILE})
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${original})
  file(READ ${original} text)
  string(FIND "${text}" "${arg_FROM}" first)
  string(FIND "${text}" "${arg_FROM}" last REVERSE)
  if(first EQUAL -1 OR NOT first EQUAL last)
    message(FATAL_ERROR "proofs/tie, mutant ${id}: \"${arg_FROM}\" does not stand exactly once in "
                        "${original}")
  endif()
  string(REPLACE "${arg_FROM}" "${arg_TO}" text "${text}")
  file(CONFIGURE OUTPUT ${mutants}/${id}/${header} CONTENT "${text}" @ONLY)
  if(NOT compiler)
    return() # CMakeLists.txt has said so
  endif()
  graze_tie_program(mutant_${id} ${compiler} ${arg_PATHS} ${arg_FLAGS} -w -I${mutants}/${id})
  add_test(NAME "proofs.tie: mutant is caught: ${title}"
           COMMAND sh -c "\"$@\"; test $? = 1" sh ${tie_build_dir}/programs/mutant_${id} ${arg_REPLAY}
                   ${vectors})
endfunction()

# The controls: the same programs without a fault pass.
if(mutant_compiler)
  foreach(paths none baseline)
    graze_tie_program(control_${paths} ${mutant_compiler} ${paths} -O1 -DGRAZE_TIE_UPWARD_ALONE)
    add_test(NAME "proofs.tie: what the mutants are made of passes (lanes: ${paths})"
             COMMAND ${tie_build_dir}/programs/control_${paths} ${vectors})
  endforeach()
endif()

set(file octree/geometry/include/graze/octree/ray_bounds.hpp)
graze_mutant(lowb_swapped "Cdn and Cup swapped in lowb" FILE ${file}
             FROM "u < number(0), a.c_up, a.c_down" TO "u < number(0), a.c_down, a.c_up")
graze_mutant(uppb_swapped "Cdn and Cup swapped in uppb" FILE ${file}
             FROM "number(0) < u, a.c_up, a.c_down" TO "number(0) < u, a.c_down, a.c_up")
graze_mutant(lowb_not_strict "<= for < in lowb" FILE ${file}
             FROM "u < number(0), a.c_up" TO "u <= number(0), a.c_up")
graze_mutant(uppb_not_strict "<= for < in uppb" FILE ${file}
             FROM "number(0) < u, a.c_up" TO "number(0) <= u, a.c_up")
graze_mutant(c_once_up "c rounded once, up" FILE ${file}
             FROM "{o, B::mul_down(mag" TO "{o, B::mul_up(mag")
graze_mutant(c_once_down "c rounded once, down" FILE ${file}
             FROM "B::mul_up(mag(other1), mag(other2))" TO "B::mul_down(mag(other1), mag(other2))")
graze_mutant(c_plain "c rounded once, by a plain product" FILE ${file}
             FROM "{o, B::mul_down(mag(other1), mag(other2)), B::mul_up(mag(other1), mag(other2)),"
             TO "{o, mag(other1) * mag(other2), mag(other1) * mag(other2),")
graze_mutant(zero_kept "no rule for zero: mag(0) = 0" FILE ${file}
             FROM "x == number(0) ? number(1) : " TO "")
graze_mutant(zero_forward "no rule for zero: d = 0 goes forward" FILE ${file}
             FROM "(number(0) < d ? heading::forward : heading::across)" TO "heading::forward")
graze_mutant(zero_backward "<= for < in the direction" FILE ${file}
             FROM "d < number(0) ? heading" TO "d <= number(0) ? heading")
graze_mutant(across_enter "< for <= on a lower face" FILE ${file}
             FROM "p <= a.origin" TO "p < a.origin")
graze_mutant(across_closed "< for <= on a closed upper face" FILE ${file}
             FROM "a.origin <= p" TO "a.origin < p")
graze_mutant(across_owned "<= for < on an upper face that is not owned" FILE ${file}
             FROM "a.origin < p," TO "a.origin <= p,")
graze_mutant(touch_strict "<= for < between leave and enter" FILE ${file}
             FROM "both.leave < both.enter" TO "both.leave <= both.enter")
graze_mutant(behind_strict "<= for < between leave and 0" FILE ${file}
             FROM "both.leave < number(0)" TO "both.leave <= number(0)")
graze_mutant(behind_kept "what lies behind the origin passes" FILE ${file}
             FROM " | (both.leave < number(0))" TO "")
graze_mutant(common_enter "the earlier of two entries" FILE ${file}
             FROM "x.enter < y.enter ?" TO "y.enter < x.enter ?")
graze_mutant(common_leave "the later of two exits" FILE ${file}
             FROM "y.leave < x.leave ?" TO "x.leave < y.leave ?")
graze_mutant(lowb_u_up "u rounded up in lowb" FILE ${file}
             FROM "B::sub_down(p, q)" TO "B::sub_up(p, q)")
graze_mutant(uppb_u_down "u rounded down in uppb" FILE ${file}
             FROM "B::sub_up(p, q)" TO "B::sub_down(p, q)")
graze_mutant(pair_swapped "Cdn and Cup swapped in both bounds at a plane" FILE ${file}
             FROM "both(a.c_up), both(a.c_down)" TO "both(a.c_down), both(a.c_up)")
graze_mutant(pair_turned "the directions of a ray swapped in both bounds at a plane" FILE ${file}
             FROM "direction == heading::forward;" TO "direction != heading::forward;")
graze_mutant(pair_across "< for <= on a lower face in both bounds at a plane" FILE ${file}
             FROM "both(p) <= both(a.origin)" TO "both(p) < both(a.origin)")
graze_mutant(one_rotation "the wrong two axes in C of y" FILE ${file}
             FROM "prepare(o[1], d[1], d[2], d[0])" TO "prepare(o[1], d[1], d[2], d[1])")

set(file octree/tree/include/graze/octree/sound.hpp)
graze_mutant(order_reversed "the order reversed" FILE ${file}
             FROM "index = i ^ origin_side" TO "index = i ^ origin_side ^ 7u")
graze_mutant(order_fixed "the order of the indices" FILE ${file}
             FROM "index = i ^ origin_side" TO "index = i ^ (origin_side & 0u)")
graze_mutant(side_strict "> for >= in the origin's side" FILE ${file}
             FROM "axes_[a].origin >= cell.mid" TO "axes_[a].origin > cell.mid")
graze_mutant(entry_side "the sides of entry swapped" FILE ${file}
             FROM "heading::backward ? 1 : 0" TO "heading::backward ? 0 : 1")
graze_mutant(half_kept "a half keeps its parent's exit" FILE ${file}
             FROM "{at[a].enter, mid.leave}" TO "at[a]")
graze_mutant(root_owned "the root's far faces not closed" FILE ${file}
             FROM "within<convention::closed>" TO "within<C>")

set(file octree/tree/include/graze/octree/sound_eight.hpp)
set(on_baseline PATHS baseline)
graze_mutant(lanes_not_strict "<= for < in the lanes" FILE ${file} ${on_baseline}
             FROM "Path::less(zero.part[i], u.part[i])"
             TO "Path::less_equal(zero.part[i], u.part[i])")
graze_mutant(lanes_swapped "Cdn and Cup swapped in the lanes" FILE ${file} ${on_baseline}
             FROM "c_up_.part[i], c_down_.part[i]" TO "c_down_.part[i], c_up_.part[i]")
graze_mutant(lanes_order "the order of the lanes' mirror reversed" FILE ${file} ${on_baseline}
             FROM "on_upper_side(positive) ^ mirror_" TO "on_upper_side(positive) ^ mirror_ ^ 7u")
graze_mutant(lanes_across "no rule for zero in the lanes" FILE ${file} ${on_baseline}
             FROM "if (across_ != 0) [[unlikely]]" TO "if (across_ == 8) [[unlikely]]")

# Flushing of subnormal numbers, within a scope and where a scope or a check lets it pass.
if(x86_64)
  set(file interval/include/graze/rounding/hardware.hpp)
  graze_mutant(scope_ftz "FTZ set in the scope" FILE ${file} FROM "up = 0x5f80" TO "up = 0xdf80")
  graze_mutant(scope_daz "DAZ set in the scope" FILE ${file} FROM "up = 0x5f80" TO "up = 0x5fc0")
  graze_mutant(scope_keeps "a scope that keeps FTZ and DAZ as found" FILE ${file} REPLAY --flush
               FROM "set_mxcsr(static_cast<unsigned>(m))"
               TO "set_mxcsr(static_cast<unsigned>(m) | (found_ & 0x8040u))")
  set(file interval/include/graze/rounding/environment.hpp)
  graze_mutant(ftz_let_pass "FTZ is not refused" FILE ${file} REPLAY --flush
               FROM "(!thread.knows_subnormal_results())" TO "(false)")
  graze_mutant(daz_let_pass "DAZ is not refused" FILE ${file} REPLAY --flush
               FROM "(!thread.knows_subnormal_operands())" TO "(false)")

  # Without -frounding-math the code holds (variants.cmake) by its barriers alone: without those it
  # does not.
  set(file interval/include/graze/rounding/hardware.hpp)
  foreach(name IN LISTS compiler_names)
    string(REPLACE "+" "x" short ${name})
    graze_mutant(no_barrier_${short} "no -frounding-math and no barrier (${name})" FILE ${file}
                 COMPILER ${path_of_${name}} FLAGS -O2 -DGRAZE_TIE_UPWARD_ALONE
                 FROM "inline double mul(double x, double y) { GRAZE_SSE_BINARY(\"mulsd\")"
                 TO "inline double mul(double x, double y) { return x * y")
  endforeach()
endif()

# The third backend.
set(file interval/include/graze/rounding/nearest.hpp)
set(all FLAGS -O1)
graze_mutant(nearest_sum "a sum to nearest that is not corrected" FILE ${file} ${all}
             FROM "sum = up_if(error > 0, sum);" TO "")
graze_mutant(nearest_product "a tiny or huge product to nearest that is not corrected"
             FILE ${file} ${all}
             FROM "if (!(a.normal() && b.normal() && p.normal())) [[unlikely]] {\n      product"
             TO "if (!(a.normal() && b.normal() && p.normal())) [[unlikely]] {\n      if (false) product")
set(file interval/include/graze/rounding/switching.hpp)
graze_mutant(switching_one_way "a mode that is not switched" FILE ${file} ${all}
             FROM "down = hardware::mode::down, up = hardware::mode::up"
             TO "down = hardware::mode::up, up = hardware::mode::up")
if(x86_64)
  set(file interval/include/graze/rounding/split.hpp)
  graze_mutant(split_nearest "the x87 rounds to nearest in split" FILE ${file} ${all}
               FROM "up_53_bits = 0x0a7f" TO "up_53_bits = 0x027f")
endif()

# Flags under which no bound can hold are refused at compile time. (clang does not tell of the parts;
# variants.cmake shows that the code holds with them.)
set(parts -freciprocal-math "-fassociative-math -fno-signed-zeros -fno-trapping-math")
foreach(name IN LISTS compiler_names)
  set(refused -ffast-math -Ofast -ffinite-math-only)
  if(name STREQUAL "g++")
    list(APPEND refused ${parts})
  endif()
  foreach(flags IN LISTS refused)
    string(REPLACE " " ";" list "${flags}")
    set(test "proofs.tie: ${flags} is refused (${name})")
    add_test(NAME ${test} COMMAND ${path_of_${name}} -std=c++20 ${list} -fsyntax-only
                                  ${include_flags} ${tie_source_dir}/replay.cpp)
    set_tests_properties(${test} PROPERTIES PASS_REGULAR_EXPRESSION "breaks every bound")
  endforeach()
endforeach()

# What clang's -fassociative-math does to the sum of `nearest` without the pragma that forbids it.
if("clang++" IN_LIST compiler_names)
  graze_mutant(nearest_reassociated "a sum whose order clang++ may change"
               FILE interval/include/graze/rounding/hardware.hpp COMPILER "${path_of_clang++}"
               FLAGS -O2 -fassociative-math -fno-signed-zeros -fno-trapping-math
               FROM "_Pragma(\"clang fp reassociate(off)\")" TO "")
endif()
