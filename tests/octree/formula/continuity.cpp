// The gaps, poles and jumps of every operation of the tape: nothing that is not continuous passes
// for it.
#include <catch2/catch.hpp>
#include <graze/octree_formula/continuity.hpp>
#include <set>
#include <vector>

using namespace graze;
using namespace graze::octree;
using tape::opcode;

namespace {

/// An operation that is undefined or jumps somewhere in the box `across`, and is continuous on
/// `clear`.
struct gap {
  opcode op;
  int n;
  bounds across_a, across_b, clear_a, clear_b;
};

const bounds around{-1, 1}, positive{1, 2}, none{0, 0}, from_zero{0, 1};

const std::vector<gap>& gaps() {
  static const std::vector<gap> all{
      {opcode::div, 0, positive, around, around, positive},
      {opcode::div, 0, positive, from_zero, around, {-2, -1}},
      {opcode::recip, 0, around, none, positive, none},
      {opcode::recip, 0, from_zero, none, {-2, -1}, none},
      {opcode::sqrt, 0, around, none, from_zero, none},
      {opcode::pow, 0, around, {0.5, 0.5}, positive, around},
      {opcode::pow, 0, from_zero, around, positive, positive},
      {opcode::atan2, 0, around, {-2, -1}, around, positive},
      {opcode::atan2, 0, around, around, positive, around},
      {opcode::pown, -1, around, none, positive, none},
      {opcode::pown, -2, around, none, {-2, -1}, none},
      {opcode::pown, -3, from_zero, none, positive, none},
      {opcode::rootn, 2, around, none, from_zero, none},
      {opcode::rootn, 4, around, none, from_zero, none},
      {opcode::rootn, 6, {-2, -1}, none, positive, none},
      {opcode::rootn, -1, around, none, positive, none},
      {opcode::rootn, -2, from_zero, none, positive, none},
      {opcode::rootn, -3, around, none, {-2, -1}, none},
      {opcode::log, 0, around, none, positive, none},
      {opcode::log, 0, from_zero, none, positive, none},
      {opcode::log2, 0, around, none, positive, none},
      {opcode::log10, 0, around, none, positive, none},
      {opcode::logp1, 0, {-2, 0}, none, from_zero, none},
      {opcode::tan, 0, positive, none, around, none},
      {opcode::cot, 0, around, none, positive, none},
      {opcode::sec, 0, positive, none, around, none},
      {opcode::csc, 0, around, none, positive, none},
      {opcode::asin, 0, positive, none, around, none},
      {opcode::acos, 0, positive, none, around, none},
      {opcode::coth, 0, around, none, positive, none},
      {opcode::csch, 0, around, none, positive, none},
      {opcode::acosh, 0, {0, 2}, none, positive, none},
      {opcode::atanh, 0, from_zero, none, {-0.5, 0.5}, none},
      {opcode::acoth, 0, {0, 2}, none, {2, 3}, none},
      {opcode::sign, 0, around, none, positive, none},
      {opcode::floor, 0, {0.5, 1.5}, none, {1.25, 1.75}, none},
      {opcode::ceil, 0, {0.5, 1.5}, none, {1.25, 1.75}, none},
      {opcode::trunc, 0, {0.5, 1.5}, none, {-0.5, 0.5}, none},
  };
  return all;
}

/// Those that are continuous at every point of R or R^2; pown and rootn are so for some n.
const std::vector<opcode> continuous{
    opcode::constant, opcode::add_constant, opcode::mul_constant, opcode::add,  opcode::sub,
    opcode::mul,      opcode::neg,          opcode::sqr,          opcode::abs,  opcode::min,
    opcode::max,      opcode::polynomial,   opcode::hypot,        opcode::cbrt, opcode::exp,
    opcode::exp2,     opcode::exp10,        opcode::expm1,        opcode::sin,  opcode::cos,
    opcode::atan,     opcode::acot,         opcode::sinh,         opcode::cosh, opcode::tanh,
    opcode::sech,     opcode::asinh};

} // namespace

TEST_CASE("octree.formula: each operation is in the list of gaps, or continuous everywhere",
          "[regression]") {
  std::set<opcode> listed(continuous.begin(), continuous.end());
  listed.insert(opcode::select); // by its operands: spellings.cpp
  CHECK_FALSE(tape::continuous_everywhere(opcode::select, 0));
  for (const gap& g : gaps())
    listed.insert(g.op);
  for (unsigned op = 0; op < static_cast<unsigned>(opcode::variable); ++op) {
    INFO(op);
    CHECK(listed.contains(static_cast<opcode>(op)));
  }
  for (const opcode op : continuous)
    CHECK(tape::continuous_everywhere(op, 0));
  for (const int n : {0, 1, 2, 3, 8})
    CHECK(tape::continuous_everywhere(opcode::pown, n));
  for (const int n : {1, 3, 7})
    CHECK(tape::continuous_everywhere(opcode::rootn, n));
  for (const gap& g : gaps()) {
    INFO(static_cast<int>(g.op) << " " << g.n << " on [" << g.across_a.lo << ", " << g.across_a.hi
                                << "]");
    CHECK_FALSE(tape::continuous_everywhere(g.op, g.n));
    CHECK_FALSE(tape::continuous_on(g.op, g.across_a, g.across_b, g.n));
    CHECK(tape::continuous_on(g.op, g.clear_a, g.clear_b, g.n));
  }
}
