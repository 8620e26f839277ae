// graze-grid-evidence: lines through random grids and boxes, exact and conservative, each judged
// exactly.
#include "dyadic_judge.hpp"
#include "hard_grids.hpp"
#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <graze/batch.hpp>
#include <graze/octree/voxel_rays.hpp>
#include <graze/support/program.hpp>
#include <graze/support/progress.hpp>
#include <mutex>

using namespace graze;
using namespace graze::grid_tests;
namespace rational = graze::oracle::rational;

namespace {

constexpr std::uint64_t lines_a_scene = 400;
constexpr unsigned widths = 8; ///< of enclosures, in ulps; the last: as many or more

enum kind {
  miss,
  spurious,
  out_of_order,
  enclosure,
  face,
  box_verdict,
  first_voxel_wrong,
  judges_differ,
  kinds
};
constexpr const char* kind_names[kinds]{
    "misses",      "spurious in exact mode",  "order errors", "enclosures", "faces", "boxes",
    "first voxel", "judges that do not agree"};
constexpr const char* kind_keys[kinds]{"misses", "spurious", "order_errors", "enclosures",
                                       "faces",  "boxes",    "first_voxel",  "judges"};

struct tally {
  std::uint64_t lines = 0, scenes = 0, touched = 0, owned = 0, reported = 0, extra = 0, boxes = 0,
                boxes_touched = 0, passages = 0, by_integers = 0, sampled = 0, segments = 0;
  std::array<std::uint64_t, 6> by_rule{};
  std::array<std::uint64_t, kinds> wrong{};
  std::array<std::uint64_t, widths> enclosures_of{}; ///< of entry and exit, by width
  std::string first_finding;

  void add(const tally& t) {
    lines += t.lines, scenes += t.scenes, touched += t.touched, owned += t.owned;
    reported += t.reported, extra += t.extra, boxes += t.boxes, boxes_touched += t.boxes_touched;
    passages += t.passages, by_integers += t.by_integers, sampled += t.sampled;
    segments += t.segments;
    for (std::size_t i = 0; i < by_rule.size(); ++i)
      by_rule[i] += t.by_rule[i];
    for (std::size_t i = 0; i < kinds; ++i)
      wrong[i] += t.wrong[i];
    for (std::size_t i = 0; i < widths; ++i)
      enclosures_of[i] += t.enclosures_of[i];
    if (first_finding.empty())
      first_finding = t.first_finding;
  }
  [[nodiscard]] bool clean() const {
    return std::all_of(wrong.begin(), wrong.end(), [](std::uint64_t n) { return n == 0; });
  }
};

std::uint64_t ulps_between(double lo, double hi) {
  return static_cast<std::uint64_t>(rounding::exact::rank(hi) - rounding::exact::rank(lo));
}

/// One grid, a place in it, and lines at it.
class scene {
public:
  scene(std::uint64_t seed, std::uint64_t number, dyadic_judge& j, tally& t)
      : number_(number), r_(seed, number),
        g_(make_grid(r_, r_.one_in(8) ? 1u << r_.between(8, 11) : 90)),
        at_(make_place(r_, g_.planes)), judge_(j), t_(t) {
    for (unsigned a = 0; a < 3; ++a)
      for (std::uint32_t k = 0; k <= at_.extent[a]; ++k) {
        const int axis = static_cast<int>(a);
        const std::uint32_t plane = at_.base[a] + k;
        // planes of other rules are doubles, which octree.grid judges; some of them here too
        planes_[a].push_back(g_.planes.rule() == plane_rule::exact
                                 ? g_.plane(a, plane)
                                 : mpq_class(g_.planes.lower(axis, plane)));
        if (g_.planes.rule() != plane_rule::given && plane < 60 && r_.one_in(8) &&
            plane_by_rule(g_.planes.rule(), g_.plan[a], g_.planes.flat(axis) ? 0 : plane) !=
                planes_[a].back())
          fails(judges_differ, "a plane is not its rule's");
      }
    judge_.planes_are(planes_);
    const bool all = !r_.one_in(3);
    std::vector<std::array<std::uint32_t, 3>> voxels;
    for (std::uint8_t x = 0; x < at_.extent[0]; ++x)
      for (std::uint8_t y = 0; y < at_.extent[1]; ++y)
        for (std::uint8_t z = 0; z < at_.extent[2]; ++z)
          if (all || r_.coin()) {
            voxels.push_back({at_.base[0] + x, at_.base[1] + y, at_.base[2] + z});
            occupied_.push_back({x, y, z});
          }
    for (unsigned a = 0; a < 3; ++a)
      far_[a] = at_.base[a] + at_.extent[a] == g_.planes.count(static_cast<int>(a));
    set_.emplace(*voxel_set::make(g_.planes, voxels));
    ++t_.scenes;
  }

  void run(std::uint64_t lines) {
    const std::uint64_t before = judge_.exactly;
    for (line_ = 0; line_ < lines && !support::stop_wanted; ++line_)
      try_line(make_line(r_, g_, at_));
    t_.by_integers += judge_.exactly - before;
    t_.by_rule[static_cast<std::size_t>(g_.planes.rule())] += line_;
  }

private:
  using triple = dyadic_judge::triple;

  void fails(kind k, const char* what) {
    if (++t_.wrong[k] == 1 && t_.first_finding.empty())
      t_.first_finding = fmt::format("{} in scene {} ({}), line {}: {}", kind_names[k], number_,
                                     name_of(g_.planes.rule()), line_, what);
  }
  static triple next(const triple& v) {
    return {static_cast<std::uint8_t>(v[0] + 1), static_cast<std::uint8_t>(v[1] + 1),
            static_cast<std::uint8_t>(v[2] + 1)};
  }
  /// Upper faces that the half-open voxel includes.
  [[nodiscard]] unsigned closed_far(const triple& v) const {
    unsigned far = 0;
    for (unsigned a = 0; a < 3; ++a)
      far |= far_[a] && v[a] + 1u == at_.extent[a] ? 1u << a : 0;
    return far;
  }
  static std::uint64_t bit(const triple& v) {
    return std::uint64_t{1} << (v[0] + 4 * v[1] + 16 * v[2]);
  }
  [[nodiscard]] triple of(const voxel& v) const {
    return {static_cast<std::uint8_t>(v.index(0) - at_.base[0]),
            static_cast<std::uint8_t>(v.index(1) - at_.base[1]),
            static_cast<std::uint8_t>(v.index(2) - at_.base[2])};
  }

  void try_line(const hard_line& l) {
    ++t_.lines;
    const ray* const as_ray = std::get_if<ray>(&l.given);
    const segment* const as_segment = std::get_if<segment>(&l.given);
    t_.segments += as_segment != nullptr;
    if (as_ray != nullptr)
      judge_.line_is(as_ray->origin(), as_ray->direction(), false, l.part.first(), l.part.last());
    else
      judge_.line_is(as_segment->from(), as_segment->to(), true, 0, 1);
    std::uint64_t touched = 0, owned = 0;
    for (const triple& v : occupied_) {
      if (!judge_.meets(v, next(v), 7, 7))
        continue;
      touched |= bit(v);
      owned |= judge_.meets(v, next(v), 7, closed_far(v)) ? bit(v) : 0;
    }
    t_.touched += static_cast<std::uint64_t>(std::popcount(touched));
    t_.owned += static_cast<std::uint64_t>(std::popcount(owned));
    std::array<voxel, 128> found;
    for (unsigned k = 0; k < 4; ++k) {
      const convention c = (k & 1) != 0 ? convention::owned : convention::closed;
      const exactness e = (k & 2) != 0 ? exactness::exact : exactness::conservative;
      std::size_t n = 0;
      const auto keep = [&](std::size_t, std::span<const voxel> some) {
        for (const voxel& v : some)
          if (n < found.size())
            found[n++] = v;
      };
      if (as_ray != nullptr)
        visit_voxels(*set_, std::span(as_ray, 1), c, e, l.part, keep);
      else
        visit_voxels(*set_, std::span(as_segment, 1), c, e, keep);
      compare_walk(std::span(found.data(), n), c, e, c == convention::owned ? owned : touched);
    }
    const exact_line line = l.prepared();
    if (r_.one_in(8))
      compare_first(l, std::span(found.data(), 1), owned);
    if (touched != 0 && r_.coin())
      compare_passage(line, touched);
    compare_box(line);
    if (r_.one_in(1024))
      compare_judges(l, line, touched, owned);
  }

  void compare_walk(std::span<const voxel> found, convention c, exactness e, std::uint64_t wanted) {
    std::uint64_t answer = 0;
    std::optional<dyadic_judge::part> before;
    for (const voxel& v : found) {
      const triple i = of(v);
      if (i[0] > 3 || i[1] > 3 || i[2] > 3 || (answer & bit(i)) != 0) {
        fails(spurious, "a voxel that is not there, or one twice");
        continue;
      }
      answer |= bit(i);
      if (c == convention::owned && (wanted & bit(i)) != 0) {
        const auto part = judge_.part_in(i, next(i));
        if (before && (judge_.order(before->first, part.first) > 0 ||
                       judge_.order(before->last, part.last) > 0))
          fails(out_of_order, "a voxel before one that the line reaches sooner");
        before = part;
      }
    }
    t_.reported += found.size();
    if ((wanted & ~answer) != 0)
      fails(miss, e == exactness::exact ? "exact" : "conservative");
    if (const std::uint64_t extra = answer & ~wanted; extra != 0) {
      if (e == exactness::exact)
        fails(spurious, "exact");
      else
        t_.extra += static_cast<std::uint64_t>(std::popcount(extra));
    }
  }

  /// `found` begins with what exact owned walks report.
  void compare_first(const hard_line& l, std::span<const voxel> found, std::uint64_t owned) {
    std::optional<voxel> hit;
    if (const ray* r = std::get_if<ray>(&l.given))
      hit = first_voxel(*set_, *r, exactness::exact, l.part);
    else
      hit = first_voxel(*set_, std::get<segment>(l.given));
    if (hit.has_value() != (owned != 0) || (hit && *hit != found[0]))
      fails(first_voxel_wrong, "another one than that of all voxels");
  }

  void compare_passage(const exact_line& line, std::uint64_t touched) {
    unsigned skip = r_.below(static_cast<unsigned>(std::popcount(touched)));
    while (skip-- != 0)
      touched &= touched - 1;
    const auto place = static_cast<unsigned>(std::countr_zero(touched));
    const triple v{static_cast<std::uint8_t>(place & 3), static_cast<std::uint8_t>(place >> 2 & 3),
                   static_cast<std::uint8_t>(place >> 4)};
    const auto p =
        line.through(g_.planes.voxel({at_.base[0] + v[0], at_.base[1] + v[1], at_.base[2] + v[2]}));
    ++t_.passages;
    if (!p)
      return fails(enclosure, "none of a voxel that is touched");
    const auto is = judge_.part_in(v, next(v));
    if (p->entered != is.entered || p->left != is.left)
      fails(face, "other faces");
    if (judge_.order_with(is.first, p->enter.lo) < 0 ||
        judge_.order_with(is.first, p->enter.hi) > 0 ||
        judge_.order_with(is.last, p->leave.lo) < 0 || judge_.order_with(is.last, p->leave.hi) > 0)
      fails(enclosure, "t is not within");
    for (const bounds& b : {p->enter, p->leave})
      if (b.hi > 0) // not where it begins
        ++t_.enclosures_of[std::min<std::uint64_t>(ulps_between(b.lo, b.hi), widths - 1)];
  }

  /// Between any planes of the place, flat ones included.
  void compare_box(const exact_line& line) {
    triple lower{}, upper{};
    slabs cell;
    unsigned flat = 0;
    for (unsigned a = 0; a < 3; ++a) {
      lower[a] = static_cast<std::uint8_t>(r_.below(at_.extent[a] + 1));
      upper[a] = static_cast<std::uint8_t>(lower[a] + r_.below(at_.extent[a] + 1 - lower[a]));
      cell.lower[a] = g_.planes.plane(static_cast<int>(a), at_.base[a] + lower[a]);
      cell.upper[a] = g_.planes.plane(static_cast<int>(a), at_.base[a] + upper[a]);
      flat |= planes_[a][lower[a]] == planes_[a][upper[a]] ? 1u << a : 0;
    }
    cell.closed_far = r_.below(8);
    const bool touched = judge_.meets(lower, upper, 7, 7);
    ++t_.boxes;
    t_.boxes_touched += touched;
    if (line.touches(cell) != touched ||
        line.crosses(cell) != judge_.meets(lower, upper, flat, flat) ||
        line.owns(cell) != judge_.meets(lower, upper, 7, cell.closed_far | flat))
      fails(box_verdict, "touches, crosses or owns");
  }

  /// This judge by the other one.
  void compare_judges(const hard_line& l, const exact_line& line, std::uint64_t touched,
                      std::uint64_t owned) {
    ++t_.sampled;
    const rational::line exact = l.rational();
    for (const triple& v : occupied_) {
      rational::box c;
      for (unsigned a = 0; a < 3; ++a) {
        c.lo[a] = planes_[a][v[a]];
        c.hi[a] = planes_[a][v[a] + 1u];
      }
      const auto is = rational::common_part(exact, c);
      if (is.has_value() != ((touched & bit(v)) != 0) ||
          rational::meets(exact, c, 7, closed_far(v)) != ((owned & bit(v)) != 0))
        fails(judges_differ, "touched or owned");
      const auto p = line.through(
          g_.planes.voxel({at_.base[0] + v[0], at_.base[1] + v[1], at_.base[2] + v[2]}));
      if (!is || !p)
        continue;
      mpq_class square = 0;
      for (const mpq_class& d : exact.velocity)
        square += d * d;
      const mpq_class duration = is->last - is->first, length = duration * duration * square;
      const auto squared = [](double x) { return mpq_class(mpq_class(x) * mpq_class(x)); };
      if (squared(p->length.lo) > length ||
          (p->length.hi < INFINITY && squared(p->length.hi) < length))
        fails(enclosure, "length");
    }
  }

  std::uint64_t number_, line_ = 0;
  random_stream r_;
  hard_grid g_;
  place at_;
  dyadic_judge& judge_;
  tally& t_;
  std::array<std::vector<mpq_class>, 3> planes_;
  std::vector<triple> occupied_;
  std::array<bool, 3> far_{};
  std::optional<voxel_set> set_;
};

struct plan {
  std::uint64_t lines = 1'000'000, seed = 1;
  double seconds = 0;
  unsigned threads = support::default_threads();
  std::optional<std::uint64_t> only;
};

/// Takes scenes, lowest first, until the lines or the time are used up.
tally run(const plan& p, double& seconds) {
  const auto start = std::chrono::steady_clock::now();
  const auto elapsed = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  const std::uint64_t scenes = p.only ? 1 : (p.lines + lines_a_scene - 1) / lines_a_scene;
  std::atomic<std::uint64_t> next{0};
  std::mutex of_sum;
  tally sum;
  const auto body = [&] {
    dyadic_judge judge;
    while (!support::stop_wanted && (p.seconds == 0 || elapsed() < p.seconds)) {
      const std::uint64_t i = next++;
      if (i >= scenes)
        break;
      tally t;
      scene s(p.seed, p.only ? *p.only : i, judge, t);
      s.run(p.only ? lines_a_scene : std::min(lines_a_scene, p.lines - i * lines_a_scene));
      const std::lock_guard lock(of_sum);
      sum.add(t);
    }
  };
  support::thread_group workers(p.threads, body, [] { support::request_stop(); });
  support::progress_line line("lines", false);
  while (!workers.wait_for(std::chrono::milliseconds(100))) {
    const std::lock_guard lock(of_sum);
    line.show({sum.lines, p.seconds > 0 ? 0 : p.lines, elapsed(), p.seconds, 0, 0});
  }
  line.clear();
  workers.join();
  seconds = elapsed();
  return sum;
}

/// The width that half of the enclosures do not exceed, and the widest.
std::pair<unsigned, unsigned> median_and_worst(const tally& t) {
  std::uint64_t all = 0, so_far = 0;
  for (const std::uint64_t n : t.enclosures_of)
    all += n;
  unsigned median = 0, worst = 0;
  for (unsigned w = 0; w < widths; ++w) {
    if (so_far * 2 < all)
      median = w;
    so_far += t.enclosures_of[w];
    worst = t.enclosures_of[w] != 0 ? w : worst;
  }
  return {median, worst};
}

void report(const tally& t, const plan& p, double seconds, bool json) {
  const auto [median, worst] = median_and_worst(t);
  const double rate = static_cast<double>(t.lines) / seconds;
  const char* const path = batch::name(batch::path_in_use());
  if (json) {
    std::string wrong, rules, of_width;
    for (unsigned k = 0; k < kinds; ++k)
      wrong += fmt::format("{}\"{}\": {}", k == 0 ? "" : ", ", kind_keys[k], t.wrong[k]);
    for (unsigned k = 0; k < t.by_rule.size(); ++k)
      rules += fmt::format("{}\"{}\": {}", k == 0 ? "" : ", ", name_of(static_cast<plane_rule>(k)),
                           t.by_rule[k]);
    for (unsigned w = 0; w < widths; ++w)
      of_width += fmt::format("{}{}", w == 0 ? "" : ", ", t.enclosures_of[w]);
    support::print(
        "{{\"lines\": {}, \"segments\": {}, \"scenes\": {}, \"seed\": {}, \"path\": \"{}\", "
        "\"seconds\": {:.1f}, \"lines_per_second\": {:.0f}, \"lines_by_rule\": {{{}}}, "
        "\"touched\": {}, \"owned\": {}, \"reported\": {}, \"conservative_extra\": {}, "
        "\"boxes\": {}, \"boxes_touched\": {}, \"passages\": {}, \"enclosures_by_ulps\": [{}], "
        "\"median_ulps\": {}, \"worst_ulps\": {}, \"compared_as_integers\": {}, "
        "\"judged_twice\": {}, \"wrong\": {{{}}}, \"interrupted\": {}}}\n",
        t.lines, t.segments, t.scenes, p.seed, path, seconds, rate, rules, t.touched, t.owned,
        t.reported, t.extra, t.boxes, t.boxes_touched, t.passages, of_width, median, worst,
        t.by_integers, t.sampled, wrong, support::interrupted());
    return;
  }
  support::print(
      "{} lines ({} segments) through {} grids, path {}, seed {}: {:.1f} s, {:.0f} lines/s\n",
      t.lines, t.segments, t.scenes, path, p.seed, seconds, rate);
  for (unsigned k = 0; k < t.by_rule.size(); ++k)
    support::print("  {:<11} {} lines\n", name_of(static_cast<plane_rule>(k)), t.by_rule[k]);
  support::print(
      "{} voxels touched, {} owned; {} reported in four modes, {} of them too many "
      "(conservative)\n{} boxes, {} touched; {} comparisons of integers; {} lines judged twice\n",
      t.touched, t.owned, t.reported, t.extra, t.boxes, t.boxes_touched, t.by_integers, t.sampled);
  std::string of_width;
  for (unsigned w = 0; w <= worst; ++w)
    of_width += fmt::format(", {} of {}", t.enclosures_of[w], w);
  support::print("enclosures of t > 0: median {} ulp, worst {} ulp{}\n", median, worst, of_width);
  for (unsigned k = 0; k < kinds; ++k)
    support::print("{:<25} {}\n", kind_names[k], t.wrong[k]);
  if (!t.first_finding.empty())
    support::print("first: {}; graze-grid-evidence --seed {} --only N repeats a scene\n",
                   t.first_finding, p.seed);
}

int start(int argc, char** argv) {
  CLI::App app{"Rays and segments through random grids and boxes, judged exactly"};
  plan p;
  bool json = false;
  app.add_option("--rays", p.lines, "rays and segments (1000000)")->check(support::whole_number());
  app.add_option("--seed", p.seed, "of all that is random (1)")->check(support::whole_number());
  app.add_option("--seconds", p.seconds, "ends after as many (no limit)")
      ->check(CLI::NonNegativeNumber);
  app.add_option("--threads", p.threads, "one a core")
      ->check(CLI::Range(1u, support::most_threads));
  app.add_option("--only", p.only, "the scene with this number alone");
  app.add_flag("--json", json, "one object on one line");
  app.footer(
      "GRAZE_BATCH_PATH=baseline|avx2|avx512 chooses the instructions.\n"
      "Exit codes: 0 nothing is wrong, 1 something is, 2 bad input or a failure, 130 interrupted.");
  if (const auto code = support::parse_arguments(app, argc, argv))
    return *code;
  support::listen_for_interrupts();
  double seconds = 0;
  const tally t = run(p, seconds);
  report(t, p, seconds, json);
  if (!t.clean())
    return support::found;
  return support::interrupted() ? support::ended_by_signal : support::done;
}

} // namespace

int main(int argc, char** argv) {
  return support::run_program("graze-grid-evidence", argc, argv, start);
}
