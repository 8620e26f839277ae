/// One path's lanes; compiled once a path, with its instructions, GRAZE_TIE_PATH its type and
/// GRAZE_TIE_NAME its name.
#include "lanes.hpp"
#include "tree.hpp"
#include <graze/batch/portable.hpp>
#include <graze/octree/sound_eight.hpp>

namespace graze::tie {
namespace {

template <octree::convention C>
void ask_in(const octree::ray& r, const lane_question& q, lane_answer& a) {
  using method = octree::sound_eight<batch::GRAZE_TIE_PATH, C>;
  using numbers = typename method::numbers;
  constexpr unsigned c = C == octree::convention::owned ? 1 : 0;
  const typename method::scope scope;
  const method m(method::bounds::prepare(r.origin(), r.direction())); // as the model: not scaled
  {
    // corner + (-0) is the corner, -0 too: any three planes can be the middle ones
    alignas(64)
        const double mid[8] = {q.mid[0], q.mid[1], q.mid[2], 0, q.mid[0], q.mid[1], q.mid[2], 0};
    alignas(64) const double ends[8] = {q.leave[0],  q.leave[1],  q.leave[2],  0,
                                        -q.enter[0], -q.enter[1], -q.enter[2], 0};
    const auto h = m.open(numbers::load(mid), -0.0, numbers::load(ends));
    alignas(64) double at_mid[8];
    h.at_mid.store(at_mid);
    for (unsigned i = 0; i < 3; ++i)
      a.leave[c][i] = at_mid[i], a.minus_enter[c][i] = at_mid[i + 4];
    a.children[c] = octree::reordered(h.passed, m.mirror());
    a.origin_side[c] = h.nearest ^ m.mirror();
  }
  if (q.kind == 'b')
    return;
  const octree::cube cell{q.lo, q.size};
  typename method::state at{};
  octree::branches<typename method::state> out;
  a.entered[c] = m.enter(cell, at);
  m.split(cell, at, out);
  a.count[c] = out.size();
  for (unsigned i = 0; i < out.size(); ++i)
    a.order[c][i] = static_cast<std::uint8_t>(out[i].index);
  if (q.kind == 't')
    a.visits[c] = visits(m, cell, a.visited[c]);
}

void ask(const octree::ray& r, const lane_question& q, lane_answer& a) {
  ask_in<octree::convention::closed>(r, q, a);
  ask_in<octree::convention::owned>(r, q, a);
}

bool runs_here() {
#if defined(__AVX512F__)
  return __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512dq") != 0;
#elif defined(__AVX2__)
  return __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0;
#else
  return true;
#endif
}

#define GRAZE_TIE_STRING(x) #x
#define GRAZE_TIE_NAMED(x) GRAZE_TIE_STRING(lanes of x)
} // namespace

extern const lane_path GRAZE_TIE_NAME;
constinit const lane_path GRAZE_TIE_NAME = {GRAZE_TIE_NAMED(GRAZE_TIE_PATH), &runs_here,
                                            !std::is_same_v<batch::GRAZE_TIE_PATH, batch::portable>,
                                            &ask};

} // namespace graze::tie
