/// The predicates on cases small enough to be checked by eye.
#include <catch2/catch.hpp>
#include <generate/generators.hpp>
#include <graze/oracle/rational.hpp>
#include <judge/replay.hpp>

using namespace graze::fuzz;

namespace {

visited seen(std::initializer_list<octant_number> list) {
  visited v;
  for (const octant_number x : list)
    v.push(x);
  return v;
}

constexpr octant_set set_of(std::initializer_list<octant_number> list) {
  octant_set s = 0;
  for (const octant_number x : list)
    s |= octant_set{1} << x;
  return s;
}

/// The eight octants of level 1.
trial eight(const vec3& o, const vec3& d) {
  trial t;
  t.origin = o;
  t.direction = d;
  t.extent = {2, 2, 2};
  return t;
}

constexpr octant_number o000 = octant_at(0, 0, 0), o100 = octant_at(1, 0, 0),
                        o010 = octant_at(0, 1, 0), o001 = octant_at(0, 0, 1),
                        o111 = octant_at(1, 1, 1), o011 = octant_at(0, 1, 1);

} // namespace

TEST_CASE("fuzz.properties: the diagonal touches eight, owns two, crosses two", "[unit]") {
  const truth exact = truth_of(eight({0, 0, 0}, {1, 1, 1}));
  CHECK(std::popcount(exact.touched) == 8);
  CHECK(exact.owned == set_of({o000, o111}));
  CHECK(exact.crossed == set_of({o000, o111}));
  REQUIRE(exact.owners == 2);
  CHECK(exact.owner_order[0] == o000);
  CHECK(exact.owner_order[1] == o111);
}

TEST_CASE("fuzz.properties: misses are judged by the promise", "[unit]") {
  const truth exact = truth_of(eight({0, 0, 0}, {1, 1, 1}));
  const visited both = seen({o000, o111});
  CHECK(misses(exact, both, promise::crossed) == 0);
  CHECK(misses(exact, both, promise::owned) == 0);
  CHECK(std::popcount(misses(exact, both, promise::touched)) == 6);
  CHECK(misses(exact, seen({o111}), promise::owned) == set_of({o000}));
  CHECK(gaps(exact, both) == 0);
  CHECK(gaps(exact, seen({o111})) == 1);
}

TEST_CASE("fuzz.properties: the root's far faces own their points", "[unit]") {
  const trial t = eight({1, 0.25, 0.25}, {0, 1, 0});
  CHECK(truth_of(t).owned == set_of({o100, octant_at(1, 1, 0)}));
  trial inner = t; // the same plane is not the root's face one level of the grid further in
  inner.root = {{0, 0, 0}, 2};
  inner.level = 2;
  CHECK(truth_of(inner).owned == 0);
  CHECK(truth_of(inner).touched == set_of({o100, octant_at(1, 1, 0)}));
}

TEST_CASE("fuzz.properties: a length in the block's hull belongs to others too, and is no gap",
          "[unit]") {
  trial t = eight({1, 0.25, 0.25}, {0, 1, 0});
  CHECK(gaps(truth_of(t), seen({})) == 2); // at the root's face there is nobody else
  t.root = {{0, 0, 0}, 2};
  t.level = 2;
  CHECK(gaps(truth_of(t), seen({})) == 0);
}

TEST_CASE("fuzz.properties: one visited neighbour covers a length in their common face", "[unit]") {
  const truth exact = truth_of(eight({0.5, 0, 0.25}, {0, 1, 0}));
  CHECK(exact.crossed == 0);
  CHECK(gaps(exact, seen({})) == 2);
  CHECK(gaps(exact, seen({o000})) == 1);
  CHECK(gaps(exact, seen({o100, o010})) == 0);
}

TEST_CASE("fuzz.properties: a seam is a gap between voxels, and no other gap is one", "[unit]") {
  const auto kinds = [](const trial& t, std::initializer_list<octant_number> answer) {
    return judge(t, truth_of(t), seen(answer), promise::crossed);
  };
  // in the face x = 1/2: two voxels on either side of each half of the ray
  const trial face = eight({0.5, 0, 0.25}, {0, 1, 0});
  CHECK(seams(truth_of(face), seen({})) == 2);
  CHECK(seams(truth_of(face), seen({o000})) == 1);
  CHECK(seams(truth_of(face), seen({o100, o010})) == 0);
  CHECK(kinds(face, {}).findings == bit(finding::seam));
  CHECK(kinds(face, {}).seams == 2);
  CHECK(kinds(face, {}).gaps == 0);
  // along an edge there are four
  CHECK(kinds(eight({0.5, 0.5, 0}, {0, 0, 1}), {}).findings == bit(finding::seam));
  // in the root's face there is one, and nobody beyond
  const verdict outer = kinds(eight({1, 0.25, 0.25}, {0, 1, 0}), {});
  CHECK(outer.findings == bit(finding::gap));
  CHECK(outer.gaps == 2);
  CHECK(outer.seams == 0);
  // through interiors there is no seam
  const verdict inner = kinds(eight({0.25, 0.25, 0}, {0, 0, 1}), {});
  CHECK(inner.seams == 0);
  CHECK(inner.gaps == 2);
}

TEST_CASE("fuzz.properties: order counts owners only", "[unit]") {
  const truth exact = truth_of(eight({0.25, 0, 0.5}, {0, 1, 0})); // in the mid-plane z = 1/2
  CHECK(exact.owned == set_of({o001, o011}));
  CHECK_FALSE(out_of_order(exact, seen({o001, o011})));
  CHECK_FALSE(out_of_order(exact, seen({o010, o001, o000, o011})));
  CHECK(out_of_order(exact, seen({o011, o001})));
  CHECK_FALSE(out_of_order(exact, seen({o011})));
}

TEST_CASE("fuzz.properties: spurious near the ray is rounding, far from it is not", "[unit]") {
  const trial near = eight({0.25, 0.25, std::nextafter(0.5, 0)}, {1, 0, 0});
  CHECK(spurious(truth_of(near), seen({o001})) == set_of({o001}));
  CHECK(far_spurious(near, truth_of(near), seen({o001})) == 0);
  const trial far = eight({0.25, 0.25, 0.25}, {1, 0, 0});
  CHECK(far_spurious(far, truth_of(far), seen({o001})) == set_of({o001}));
}

TEST_CASE("fuzz.properties: of a traversal in float a voxel is far beyond roundings of float alone",
          "[regression]") {
  struct float_walk final : traversal {
    [[nodiscard]] std::string_view name() const override { return "in-float"; }
    [[nodiscard]] promise promises() const override { return promise::first; }
    [[nodiscard]] bool in_float() const override { return true; }
    void visit(const trial& /*t*/, visited& out) override { out.push(o001); }
  } under_test;
  const auto found = [&](double below, promise p) {
    const trial t = eight({0.25, 0.25, 0.5 - below}, {1, 0, 0});
    visited answer = seen({o001});
    answer.said().hit = true;
    return judge_answer(t, answer, p, allowance_of(under_test)).findings &
           bit(finding::far_spurious);
  };
  for (const promise p : {promise::crossed, promise::first, promise::first_touched}) {
    CHECK(found(0x1p-24, p) == 0);
    CHECK(found(0x1p-19, p) == 0);
    CHECK(found(0x1p-16, p) != 0);
  }
  const trial near = eight({0.25, 0.25, 0.5 - 0x1p-24}, {1, 0, 0});
  CHECK(far_spurious(near, truth_of(near), seen({o001})) == set_of({o001})); // in double
  CHECK((judge(near, under_test).findings & bit(finding::far_spurious)) == 0);
  CHECK((replay(near, under_test).findings & bit(finding::far_spurious)) == 0);
}

TEST_CASE("fuzz.properties: what is gross is what rationals say", "[property]") {
  int wrong = 0, gross_ones = 0, others = 0;
  for (const generator& g : generators())
    for (const int level : {1, 10, 30, 50, 53})
      for (unsigned k = 0; k < 100; ++k) {
        const trial t = make_trial(g, 77, k, level);
        mpq_class square = 0;
        for (const double d : t.direction)
          square += mpq_class(d) * mpq_class(d);
        const mpq_class least = mpq_class(t.size()) / 1000;
        const octant_set judged = gross(t, t.all());
        for (octant_set left = t.all(); left != 0; left &= left - 1) {
          const auto v = static_cast<octant_number>(std::countr_zero(left));
          const cube box = t.octant(v);
          const auto in = graze::oracle::rational::range_in(t.origin, t.direction, box.lo,
                                                            {box.hi(0), box.hi(1), box.hi(2)});
          const mpq_class span = in ? in->second - in->first : mpq_class(0);
          const bool is_gross = span * span * square > least * least;
          wrong += is_gross != ((judged >> v & 1) != 0);
          ++(is_gross ? gross_ones : others);
        }
      }
  CHECK(wrong == 0);
  CHECK(gross_ones > 1000);
  CHECK(others > 1000);
}

TEST_CASE("fuzz.properties: a miss is gross where the chord is over 1e-3 of the edge", "[unit]") {
  // in the octant of [1/2,1]^3 from (1 - c, 1/2) on: a chord of sqrt(2) c, in an edge of 1/2
  const auto found = [](double c, const vec3& scale) {
    const trial t = eight({1 - c, 0.5, 0.75}, {scale[0], scale[1], 0});
    const truth exact = truth_of(t);
    CHECK(exact.crossed == set_of({o111}));
    return judge(t, exact, seen({}), promise::crossed).findings;
  };
  constexpr double limit = 1e-3 * 0.5 / 1.4142135623730951;
  for (const double scale : {1.0, 0x1p-1000, 0x1p+1000}) {
    CHECK((found(limit * (1 - 1e-12), {scale, scale, 0}) & bit(finding::gross_miss)) == 0u);
    CHECK((found(limit * (1 + 1e-12), {scale, scale, 0}) & bit(finding::gross_miss)) != 0u);
  }
  CHECK((found(limit, {1, 1, 0}) & bit(finding::crossed_miss)) != 0u);
  const trial t = eight({0, 0, 0}, {1, 1, 1}); // what is only touched is never gross
  CHECK(gross(t, set_of({o100})) == 0);
  CHECK(gross(t, set_of({o000, o111})) == set_of({o000, o111}));
}

TEST_CASE("fuzz.properties: a repeated octant and one from outside are noticed", "[unit]") {
  const trial t = eight({0, 0, 0}, {1, 1, 1});
  visited answer = seen({o000, o111, o000});
  CHECK(answer.repeated());
  CHECK(judge(t, truth_of(t), answer, promise::owned).findings == bit(finding::revisit));
  answer = seen({o000, o111});
  answer.push_outside();
  CHECK(judge(t, truth_of(t), answer, promise::owned).findings == bit(finding::outside));
  answer.clear();
  CHECK_FALSE(answer.outside());
  CHECK(answer.size() == 0);
}

namespace {

/// The same trial with its axes renamed: x becomes y, y becomes z, z becomes x.
trial turned(const trial& t) {
  trial r = t;
  for (unsigned a = 0; a < 3; ++a) {
    const unsigned b = (a + 1) % 3;
    r.origin[b] = t.origin[a];
    r.direction[b] = t.direction[a];
    r.root.lo[b] = t.root.lo[a];
    r.base[b] = t.base[a];
    r.extent[b] = t.extent[a];
  }
  return r;
}
octant_number turned(octant_number v) { return octant_at(v >> 4, v & 3u, v >> 2 & 3u); }
octant_set turned(octant_set s) {
  octant_set r = 0;
  for (; s != 0; s &= s - 1)
    r |= octant_set{1} << turned(static_cast<octant_number>(std::countr_zero(s)));
  return r;
}

} // namespace

TEST_CASE("fuzz.properties: the truth does not depend on the names of the axes", "[property]") {
  unsigned lengths = 0, owners = 0;
  for (const generator& g : generators())
    for (std::uint64_t k = 0; k < 300; ++k) {
      const trial t = make_trial(g, 61, k, std::array{1, 2, 10, 50}[k % 4]);
      const truth exact = truth_of(t), same = truth_of(turned(t));
      INFO(g.name << " " << k);
      REQUIRE(same.touched == turned(exact.touched));
      REQUIRE(same.owned == turned(exact.owned));
      REQUIRE(same.crossed == turned(exact.crossed));
      REQUIRE(same.owners == exact.owners);
      for (unsigned i = 0; i < exact.owners; ++i)
        REQUIRE(same.owner_order[i] == turned(exact.owner_order[i]));
      REQUIRE(same.length_count == exact.length_count);
      for (unsigned i = 0; i < exact.length_count; ++i)
        REQUIRE(same.lengths[i] == turned(exact.lengths[i]));
      lengths += exact.length_count;
      owners += exact.owners;
    }
  CHECK(lengths > 1000);
  CHECK(owners > 1000);
}

TEST_CASE("fuzz.properties: each kind of finding is found, by itself", "[unit]") {
  const auto found = [](const trial& t, std::initializer_list<octant_number> answer, promise p) {
    return judge(t, truth_of(t), seen(answer), p).findings;
  };
  // along the edge x = y = 1/2: it touches all eight, owns two of them, crosses none
  const trial edge = eight({0.5, 0.5, 0}, {0, 0, 1});
  const octant_number o110 = octant_at(1, 1, 0), o101 = octant_at(1, 0, 1);
  CHECK(found(edge, {o110, o111}, promise::owned) == 0u);
  CHECK(found(edge, {}, promise::crossed) == bit(finding::seam));
  CHECK(found(edge, {o000, o111}, promise::crossed) == 0u);
  CHECK(found(edge, {o110, o111}, promise::touched) == bit(finding::miss));
  CHECK(found(edge, {o000, o111}, promise::owned) == bit(finding::miss));
  CHECK(found(edge, {o111, o110}, promise::owned) == bit(finding::order));
  CHECK(found(edge, {o111, o110}, promise::crossed) == 0u);
  // touched, but not owned: one too many for who promises the owners exactly
  CHECK(found(edge, {o110, o111, o101}, promise::exactly_owned) == bit(finding::spurious));
  CHECK(found(edge, {o110, o111, o101}, promise::owned) == 0u);
  CHECK(found(edge, {o000, o100, o010, o110, o001, o101, o011, o111}, promise::exactly_touched) ==
        0u);
  // through the middle of an octant
  const trial through = eight({0.25, 0.25, 0}, {0, 0, 1});
  CHECK(found(through, {o000, o001}, promise::exactly_owned) == 0u);
  CHECK((found(through, {o000}, promise::owned) & bit(finding::crossed_miss)) != 0u);
  CHECK((found(through, {o000, o001, o111}, promise::owned)) == bit(finding::far_spurious));
}
