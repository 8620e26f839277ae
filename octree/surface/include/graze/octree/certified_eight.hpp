#pragma once
/// Certified first hits with a ray in each lane of a path: the results of certified_traversal.
#include <graze/needs_cxx20.hpp>

#include <graze/octree/certified_hit.hpp>
#include <graze/octree/inclusion_eight.hpp>

namespace graze::octree {

/// The lanes of certified_search in the registers of a path.
template <class Path> struct eight_lanes {
  static constexpr std::size_t count = 8;
  using number = octet<Path>;
  using interval = interval8<Path>;

#define GRAZE_LANES static GRAZE_BATCH_INLINE
  GRAZE_LANES number load(const double* x) { return number::load(x); }
  GRAZE_LANES void store(double* to, const number& x) { x.store(to); }
  GRAZE_LANES number broadcast(double x) { return number::broadcast(x); }
  GRAZE_LANES number lower(const interval& x) {
    number r;
#pragma GCC unroll 8
    for (std::size_t i = 0; i < number::count; ++i)
      r.part[i] = x.registers(i).lo;
    return r;
  }
  GRAZE_LANES number upper(const interval& x) {
    number r;
#pragma GCC unroll 8
    for (std::size_t i = 0; i < number::count; ++i)
      r.part[i] = x.registers(i).hi;
    return r;
  }
  GRAZE_LANES interval between(const number& lo, const number& hi) {
    batch::part<Path> p[number::count];
#pragma GCC unroll 8
    for (std::size_t i = 0; i < number::count; ++i)
      p[i] = {lo.part[i], hi.part[i]};
    return interval::from_registers(p);
  }
  GRAZE_LANES number add_down(const number& x, const number& y) {
    return number::template each<&Path::add_down>(x, y);
  }
  GRAZE_LANES number add_up(const number& x, const number& y) { return number::add_up(x, y); }
  GRAZE_LANES number sub_down(const number& x, const number& y) {
    return number::template each<&Path::sub_down>(x, y);
  }
  GRAZE_LANES number sub_up(const number& x, const number& y) { return number::sub_up(x, y); }
  GRAZE_LANES number mul_down(const number& x, const number& y) {
    return number::template each<&Path::mul_down>(x, y);
  }
  GRAZE_LANES number mul_up(const number& x, const number& y) { return number::mul_up(x, y); }
  GRAZE_LANES number div_down(const number& x, const number& y) {
    return number::template each<&Path::div_down>(x, y);
  }
  GRAZE_LANES number div_up(const number& x, const number& y) {
    return number::template each<&Path::div_up>(x, y);
  }
  GRAZE_LANES number min(const number& x, const number& y) { return number::min(x, y); }
  GRAZE_LANES number max(const number& x, const number& y) { return number::max(x, y); }
  GRAZE_LANES number neg(const number& x) { return number::neg(x); }
  GRAZE_LANES number centre(const number& lo, const number& hi) {
    return number::template each<&detail::centre<Path>>(lo, hi);
  }
  GRAZE_LANES unsigned less(const number& x, const number& y) { return number::less(x, y); }
  GRAZE_LANES unsigned less_equal(const number& x, const number& y) {
    return number::less_equal(x, y);
  }
  GRAZE_LANES number chosen(unsigned mask, const number& q, const number& p) {
    return octree::chosen(mask & 0xff, q, p);
  }
#undef GRAZE_LANES
};

/// As for scalar intervals (dual.hpp): Clarke's generalized gradient across the crease.
template <class Path, std::size_t P>
GRAZE_BATCH_INLINE dual<interval8<Path>, P> lesser(const dual<interval8<Path>, P>& a,
                                                   const dual<interval8<Path>, P>& b) {
  dual<interval8<Path>, P> r{min(a.value, b.value), {}};
  for (std::size_t i = 0; i < P; ++i)
    r.partial[i] = interval8<Path>::template lanewise<&detail::lesser_lanes<Path>::partial>(
        a.value, b.value, a.partial[i], b.partial[i]);
  return r;
}

/// The first hit of each ray: a lane takes the next ray when it has done with one. Within no scope.
template <class Path, Surface F>
void certified_hits_eight(const F& f, const box& domain, const ray* rays, std::size_t ray_count,
                          certified_hit* hits, std::uint64_t* steps) {
  using search = certified_search<eight_lanes<Path>, F>;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const typename Path::scope scope;
  if (results_are_flushed()) {
    for (std::size_t i = 0; i < ray_count; ++i)
      hits[i] = {verdict::undecided, false, 0, infinity};
    return;
  }
  search s(f);
  typename search::prepared ready;
  std::size_t of_lane[8], base = 0, next = 0;
  unsigned waiting = 0; // of those that are ready
  double taken = 0;
  // Gives a lane the next ray that meets the domain; nothing happens where there is none.
  const auto begin = [&](std::size_t lane) {
    while (waiting == 0 && next < ray_count) {
      base = next;
      const std::size_t here = std::min<std::size_t>(8, ray_count - next);
      for (std::size_t k = 0; k < 8; ++k) {
        const ray& r = rays[base + std::min(k, here - 1)];
        for (int a = 0; a < 3; ++a) {
          ready.origin[a][k] = r.origin()[a];
          ready.direction[a][k] = r.direction()[a];
        }
      }
      next += here;
      const unsigned there = (1u << here) - 1;
      waiting = ready.clip(domain) & there;
      for (unsigned rest = there & ~waiting; rest != 0; rest &= rest - 1)
        hits[base + static_cast<unsigned>(std::countr_zero(rest))] = {verdict::miss, false,
                                                                      infinity, infinity};
    }
    if (waiting == 0)
      return;
    const auto k = static_cast<std::size_t>(std::countr_zero(waiting));
    waiting &= waiting - 1;
    of_lane[lane] = base + k;
    s.begin(lane, ready, k);
  };
  for (std::size_t lane = 0; lane < 8; ++lane)
    begin(lane);
  while (s.active() != 0)
    for (unsigned finished = s.step(); finished != 0; finished &= finished - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(finished));
      hits[of_lane[lane]] = s.result(lane);
      taken += s.steps(lane);
      begin(lane);
    }
  if (steps != nullptr)
    *steps += static_cast<std::uint64_t>(taken);
}

} // namespace graze::octree
