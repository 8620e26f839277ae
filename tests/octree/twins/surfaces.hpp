#pragma once
/// The surfaces of which twins are compared: those of the scenes, a formula for every operation of
/// the tape, and random ones.
#include "../surface_scenes.hpp"
#include <graze/octree_formula.hpp>
#include <graze/oracle/formula_tree.hpp>
#include <string>
#include <vector>

namespace graze::twins {

/// A formula for every operation of the tape: by itself, of a product, and beside others.
inline std::vector<std::string> operation_texts() {
  std::vector<std::string> all{
      "x",
      "0.1",
      "x+0.1",
      "0.1*x-y",
      "x*y-z",
      "-x/y+z",
      "1/(x*y)-z",
      "y*z*x-z",
      "1/x+y+z",
      "x-y/(z*z-0.5)",
      "min(x,y*z)",
      "max(x-y,min(z,0.1))",
      "min(x^2+y^2+z^2-1,(x-1)^2+y^2+z^2-0.5,max(abs(x)-0.9,abs(y)-0.9,abs(z)-0.2))",
      "difference(x^2+y^2+z^2-1,x-0.25*y)",
      "union(sqrt(x)-y,1/z)",
      "hypot(x,hypot(y,z))-0.7*abs(sin(5*atan2(y,x)))",
      "hypot(x*y,z)-1",
      "atan2(y,x)-z",
      "atan2(x*y-0.1,z)",
      "pow(abs(x)+0.1,y)-z",
      "pow(x,y*z)-0.5",
      // polynomials in one variable or one part: with simple, double and no turns; their
      // cancellations
      "x^3-1.5*x^2+0.75*x-1/8+1/2^54",
      "x^3-x+y*z",
      "x^4-2*x^2+y^5-y+z",
      "x^4-4*x^3+6*x^2-4*x+y",
      "x^6-6*x^5+15*x^4-20*x^3+15*x^2-6*x+y",
      "x^8-4*x^6+6*x^4-4*x^2",
      "(x*y)^3-3*(x*y)^2+2*(x*y)-z",
      "x^9-0.1*x^7+x^2-1e300*y^3+y",
      "1e-300*x^5-1e-300*x+y^3*1e-160-z",
      "0.1*x^3-0.3*x^2+0.3*x-0.1+(y^2-2*y+1)*z",
      "x^5-x*y+y^3*z-0.1*z^7+x^2*y^2",
      // several functions
      "x^4-5x^2+y^4-5y^2+z^4-5z^2+11.8",
      "x^3+y^3+z^3-x-y-z",
      "sin(3x)*cos(2y)-z*exp(-x^2)+0.1",
      "1/(x-0.3)-y/(z^2-0.5)",
      "sqrt(x-0.1)+log(y+0.5)-cbrt(z)",
      "tan(2x)-atan2(y,z)",
      "acos(x)-asin(y)+atanh(z)-tanh(x*y)",
      "floor(3x)/2-y*z+sech(x)-csch(y)",
      "rootn(x,3)-rootn(y+0.5,4)+z^-3/9-x^40",
      // choices
      "if(x<y,z-x*y,sqrt(z))",
      "if(x>=0,y-z,x*z-0.5)",
      "if(x*y-z>0.1,sqrt(x)-y,1/z)",
      "if(x<0 and y>0 or z==0,x*y-z,y^3-x)",
      "if(sqrt(x)<y,log(y),z-x)",
      "mod(x,0.3)-y*z",
      "x%y-z",
      "clamp(x-y,-0.5,0.5)-|z|",
      // subnormal and huge
      "(x*2^1000-1/2^74)^2*2^148 + y*z + y - z/2 - 1/10",
      "(x*2^1000-1/2^74)^2*2^148 + y*2^1000 - z*2^999 + y*z",
      "x*y*z*2^1000-x+y*z",
      "x*1e-300-y*z*1e-300",
  };
  for (const int n : {-40, -7, -3, -2, -1, 0, 1, 2, 3, 4, 5, 6, 7, 8, 13, 16, 31, 32, 33, 40, 63}) {
    const std::string power = "pown(x," + std::to_string(n) + ")";
    all.push_back(power + "-y*z");
    all.push_back("pown(x*y-z," + std::to_string(n) + ")-0.25");
  }
  for (const int n : {-3, -2, 2, 3, 4, 5, 8, 9}) {
    all.push_back("rootn(x," + std::to_string(n) + ")-y*z");
    all.push_back("rootn(x*y-z," + std::to_string(n) + ")-0.5");
  }
  for (const char* name : {"sqr", "sqrt", "abs",
#define GRAZE_TWINS_NAME(f) #f,
                           GRAZE_TAPE_FUNCTIONS(GRAZE_TWINS_NAME)
#undef GRAZE_TWINS_NAME
       }) {
    const std::string f = std::string(name) == "logp1" ? "log1p" : name;
    all.push_back(f + "(x)-y*z");
    all.push_back(f + "(x*y-z)+0.1");
    all.push_back("y*" + f + "(2*x+0.5)-z^2");
  }
  return all;
}

/// Random formulas, the same every time; texts that are refused (a constant part without a value)
/// are left out.
inline std::vector<std::string> random_texts(std::uint64_t seed, std::size_t count) {
  std::vector<std::string> all;
  oracle::random_bits random(seed);
  while (all.size() < count) {
    const bool arithmetic = random() % 3 == 0;
    const auto t = oracle::some_tree(random, 1 + static_cast<int>(random() % 4), arithmetic);
    if (octree::formula::parse(t->text))
      all.push_back(t->text);
  }
  return all;
}

inline octree::formula parsed(const std::string& text) {
  const auto f = octree::formula::parse(text);
  INFO(text << ": " << f.reason());
  REQUIRE(f);
  return *f;
}

} // namespace graze::twins
