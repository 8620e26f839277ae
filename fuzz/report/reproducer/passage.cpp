#include <cmath>
#include <fmt/format.h>
#include <graze/oracle/rational.hpp>
#include <report/reproducer/passage.hpp>
#include <trial/number.hpp>

namespace graze::fuzz {

passage passage_of(const trial& t, const cube& box) {
  passage p{};
  p.range =
      oracle::rational::range_in(t.origin, t.direction, box.lo, {box.hi(0), box.hi(1), box.hi(2)});
  bool found = false;
  bool beside = false; // the edge found is one that the ray passes, not the edge's extension
  for (unsigned first = 0; first < 3; ++first)
    for (unsigned second = first + 1; second < 3; ++second) {
      const bool faster = std::fabs(t.direction[first]) >= std::fabs(t.direction[second]);
      const unsigned along = faster ? first : second;
      const unsigned across = faster ? second : first;
      const unsigned third = 3 - first - second;
      if (t.direction[along] == 0)
        continue;
      for (unsigned far = 0; far < 4; ++far) {
        std::array<double, 3> corner = box.lo;
        if ((far & 1u) != 0)
          corner[along] = box.hi(static_cast<int>(along));
        if ((far & 2u) != 0)
          corner[across] = box.hi(static_cast<int>(across));
        const mpq_class at =
            (mpq_class(corner[along]) - mpq_class(t.origin[along])) / mpq_class(t.direction[along]);
        const auto place = [&](unsigned axis) -> mpq_class {
          return mpq_class(t.origin[axis]) + at * mpq_class(t.direction[axis]);
        };
        const mpq_class distance = place(across) - mpq_class(corner[across]);
        const mpq_class height = place(third);
        const bool passes = at >= 0 && height >= mpq_class(box.lo[third]) &&
                            height <= mpq_class(box.hi(static_cast<int>(third)));
        const bool nearer = passes == beside ? abs(distance) < abs(p.distance) : passes;
        if (found && !nearer)
          continue;
        found = true;
        beside = passes;
        p.along = along;
        p.across = across;
        p.corner = corner;
        p.distance = distance;
      }
    }
  const double largest =
      std::max({std::fabs(t.origin[p.across]), std::fabs(p.corner[p.across]), box.size});
  p.ulp = largest - step_ulps(largest, -1);
  if (significant_bits(largest) == 1) // below a power of two the gap is half of that above
    p.ulp = step_ulps(largest, 1) - largest;
  return p;
}

double passage::distance_in_ulps() const {
  const mpq_class ratio = abs(distance) / mpq_class(ulp);
  return ratio.get_d();
}

double passage::chord(const trial& t) const {
  if (!range)
    return 0;
  double fastest = 0;
  for (const double d : t.direction)
    fastest = std::max(fastest, std::fabs(d));
  const mpq_class length =
      (range->second - range->first) * mpq_class(fastest) / mpq_class(t.size());
  return length.get_d();
}

std::string spelled_short(double x) {
  if (x == 0)
    return std::signbit(x) ? "-0" : "0";
  const double sixteenths = x * 16; // decimals of at most four places
  if (std::fabs(x) < 0x1p20 && std::trunc(sixteenths) == sixteenths)
    return fmt::format("{:.10g}", x);
  return hex(x);
}

std::string spelled(const mpq_class& x) {
  std::string exact = x.get_str();
  if (exact.size() <= 24)
    return exact;
  return fmt::format("about {:.17g}", x.get_d());
}

std::string spelled(const vec3& v) {
  return fmt::format("({}, {}, {})", hex(v[0]), hex(v[1]), hex(v[2]));
}

std::string_view claim_of(finding kind, promise p) {
  switch (kind) {
  case finding::gross_miss:
    return "the ray crosses its interior, on more than 1e-3 of its edge";
  case finding::crossed_miss:
    return "the ray crosses its interior";
  case finding::gap:
    return "a length of the ray lies in it, and in no octant that was visited";
  case finding::seam:
    return "the ray runs in the face of two voxels, and neither was reported";
  case finding::miss:
    return promises_owned(p) ? "a point of the ray is in it (closed at its lower faces only)"
                             : "the ray touches the closed box";
  case finding::far_spurious:
  case finding::spurious:
    return p == promise::exactly_owned ? "no point of the ray is in it (closed at its lower faces)"
                                       : "the ray does not touch it";
  case finding::order:
    return "the ray meets it before the octants that were visited earlier";
  case finding::crash:
  case finding::hang:
  case finding::exception:
  case finding::not_a_number:
  case finding::malformed:
  case finding::distance:
  case finding::face:
  case finding::count:
    return sentence_of(kind);
  default:
    return "the octant of the finding";
  }
}

bool is_fault(finding kind) { return kind <= finding::malformed; }

std::string_view fault_of(finding kind) {
  switch (kind) {
  case finding::gross_miss:
  case finding::crossed_miss:
  case finding::gap:
  case finding::seam:
  case finding::miss:
    return "missed";
  case finding::order:
    return "visited too late";
  case finding::revisit:
    return "visited twice, or one beside it";
  case finding::distance:
  case finding::face:
    return "named as the first";
  case finding::count:
    return "asked about";
  case finding::outside:
    return "visited, with one outside of the block";
  case finding::crash:
  case finding::hang:
  case finding::exception:
  case finding::not_a_number:
  case finding::malformed:
    return "asked about (the block's first; none is to blame)";
  default:
    return "visited for nothing";
  }
}

} // namespace graze::fuzz
