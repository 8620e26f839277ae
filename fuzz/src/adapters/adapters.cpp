#include "adapters.hpp"
#include "box_traversal.hpp"
#include "slab_tests.hpp"
#include <graze/fuzz/method_traversal.hpp>
#include <graze/octree/revelles.hpp>

namespace graze::fuzz {

namespace {

constexpr char amanatides_woo[] = "amanatides-woo", revelles[] = "revelles",
               williams[] = "williams", ize[] = "ize", tavian[] = "tavian", pbrt[] = "pbrt",
               rational[] = "rational";

template <std::unique_ptr<traversal> (*Make)(std::string_view), const char* Name>
std::unique_ptr<traversal> named() {
  return Make(Name);
}

template <class Test, const char* Name> std::unique_ptr<traversal> box_by_box() {
  return std::make_unique<box_traversal<Test>>(Name);
}

/// The root and the ray as they are, in double; the descent is the one of our own traversals.
std::unique_ptr<traversal> make_revelles() {
  return std::make_unique<method_traversal<octree::revelles>>(revelles, promise::crossed);
}

} // namespace

const std::vector<traversal_entry>& adapters() {
  static const std::vector<traversal_entry> all{
      {amanatides_woo, "grid walk by the next plane in t (Amanatides and Woo 1987)",
       named<make_amanatides_woo, amanatides_woo>},
      {revelles, "parametric octree descent (Revelles, Urena and Lastra 2000)", make_revelles},
      {williams, "ray/box test by slabs (Williams, Barrus, Morley and Shirley 2005)",
       box_by_box<williams_test, williams>},
      {ize, "ray/box test, far side padded by 2 ulps (Ize 2013)", box_by_box<ize_test, ize>},
      {tavian, "branchless ray/box test, boundaries included (Tavian Barnes 2022)",
       box_by_box<tavian_test, tavian>},
      {pbrt, "ray/box test of pbrt: Bounds3::IntersectP, far side padded by gamma(3)",
       box_by_box<pbrt_test, pbrt>},
      {rational, "exact rationals, octant by octant: the reference",
       named<make_rational, rational>},
  };
  return all;
}

} // namespace graze::fuzz
