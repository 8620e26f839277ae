#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <initializer_list>
#include <report/reproducer/passage.hpp>
#include <trial/number.hpp>

namespace graze::fuzz {

namespace {

/// The k for which all numbers times 2^k are integers below 2^bits; nothing if there is none that
/// a double's power of two reaches.
std::optional<int> integer_scale(std::initializer_list<vec3> vectors, int bits) {
  int lowest = INT32_MAX;
  int highest = INT32_MIN;
  for (const vec3& v : vectors)
    for (const double x : v)
      if (x != 0) {
        lowest = std::min(lowest, octree::detail::lowest_bit_exponent(x));
        highest = std::max(highest, std::ilogb(x));
      }
  if (highest == INT32_MIN)
    return 0;
  lowest = std::min(lowest, 0); // integers stay as they are
  if (highest - lowest >= bits || lowest < -1000)
    return std::nullopt;
  return -lowest;
}

std::string array_of(const vec3& v) {
  return fmt::format("{{{}, {}, {}}}", hex(v[0]), hex(v[1]), hex(v[2]));
}

/// The letters and digits of a name, "_" for all others.
std::string identifier(std::string name) {
  for (char& c : name)
    if (!((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9')))
      c = '_';
  return "graze_" + name;
}

/// A traversal's name may be a command line, and must not end the comment or go on with it.
std::string in_comment(std::string name) {
  for (char& c : name)
    if (static_cast<unsigned char>(c) < 0x20 || c == '\\')
      c = ' ';
  return name;
}

/// One comparison decides the octant: strict for the open interior, weak for the closed box.
struct relation {
  std::string_view name, sense, less, not_behind, assertion;
};

/// What can be asserted; nothing where the finding is not about whether the ray meets the box.
std::optional<relation> relation_of(const reproduction& r) {
  switch (r.kind) {
  case finding::gross_miss:
  case finding::crossed_miss:
    return relation{"crosses_interior", "the open interior", "<", "> 0", "crosses_interior()"};
  case finding::gap:
  case finding::seam:
  case finding::miss:
    return relation{"touches", "the closed box", "<=", ">= 0", "touches()"};
  case finding::far_spurious:
  case finding::spurious:
    if ((r.judged.touches >> r.subject & 1) != 0) // it is touched, and not owned
      return relation{"touches", "the closed box", "<=", ">= 0", "touches()"};
    return relation{"touches", "the closed box", "<=", ">= 0", "!touches()"};
  default:
    return std::nullopt;
  }
}

} // namespace

std::string reproducer_snippet(const reproduction& r) {
  const trial& t = r.answered;
  const cube box = r.octant();
  const vec3 hi{box.hi(0), box.hi(1), box.hi(2)};
  std::string text = fmt::format("// {} by {}: {}", name_of(r.kind), in_comment(r.traversal),
                                 claim_of(r.kind, r.promises));
  if (!is_fault(r.kind))
    text += fmt::format(" (octant {})", fault_of(r.kind));
  text += fmt::format(".\n// Root {} size {}, level {}.\n", spelled(t.root.lo), hex(t.root.size),
                      t.level);
  text += fmt::format("namespace {} {{\n", identifier(reproducer_name(r)));
  text += fmt::format("constexpr double origin[3] = {};\n", array_of(t.origin));
  text += fmt::format("constexpr double direction[3] = {};\n", array_of(t.direction));
  text += fmt::format("constexpr double lo[3] = {};\n", array_of(box.lo));
  text += fmt::format("constexpr double hi[3] = {};\n", array_of(hi));
  const auto claim = relation_of(r);
  // differences below 2^64 times directions below 2^62 fit 127 bits
  const auto place_scale = integer_scale({t.origin, box.lo, hi}, 63);
  const auto direction_scale = integer_scale({t.direction}, 62);
  if (claim && place_scale && direction_scale) {
    text += fmt::format(
        R"(// Times 2^{0} and 2^{1} these are integers: whether the ray meets {2} is decided
// here without rounding. On any two axes it enters on one before it leaves on the other.
__extension__ typedef __int128 integer;
constexpr integer place(double x) {{ return static_cast<integer>(x * {3}); }}
constexpr integer speed(int axis) {{ return static_cast<integer>(direction[axis] * {4}); }}
constexpr integer way_to(int axis, bool far) {{
  return direction[axis] < 0 ? place(origin[axis]) - place((far ? lo : hi)[axis])
                             : place((far ? hi : lo)[axis]) - place(origin[axis]);
}}
constexpr bool {5}() {{
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {{
      const integer along_i = speed(i) < 0 ? -speed(i) : speed(i);
      const integer along_j = speed(j) < 0 ? -speed(j) : speed(j);
      const bool before = way_to(i, false) * along_j {6} way_to(j, true) * along_i;
      if ((along_i != 0 || along_j != 0) && !before)
        return false;
      if (!(way_to(i, true) {7}))
        return false;
    }}
  return true;
}}
static_assert({8}, "decided by integers");
)",
        *place_scale, *direction_scale, claim->sense, hex(std::ldexp(1.0, *place_scale)),
        hex(std::ldexp(1.0, *direction_scale)), claim->name, claim->less, claim->not_behind,
        claim->assertion);
  } else if (const passage p = passage_of(t, box); p.range) {
    text += fmt::format("// In the closed box for t from {} to {} (rationals).\n",
                        spelled(p.range->first), spelled(p.range->second));
  }
  return text + "}\n";
}

} // namespace graze::fuzz
