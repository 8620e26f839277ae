// Campaigns on our own code: nothing is found on what is shipped, each subject reports what is
// broken on purpose, and a crash, a hang or an interrupt loses nothing.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <csignal>
#include <graze/decorated_functions.hpp>
#include <limits>
#include <self/batches.hpp>
#include <self/campaign.hpp>
#include <self/formula.hpp>
#include <self/interval_operations.hpp>
#include <self/loaders.hpp>
#include <self/voxelizer.hpp>
#include <unistd.h>
#if defined(__x86_64__)
#include <graze/rounding/split.hpp>
#include <graze/rounding/upward.hpp>
#include <self/control_words.hpp>
#endif

using namespace graze;
using namespace graze::fuzz::self;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
const std::atomic<bool> never{false};

result campaign(const subject& s, std::uint64_t trials, unsigned processes = 2,
                std::uint64_t first = 0) {
  const plan p{{.seed = 1, .first = first, .trials = trials, .workers = processes}, &s};
  const auto r = run(p, never);
  REQUIRE(r);
  INFO(to_text(p, *r));
  CHECK(r->trials == trials);
  return *r;
}

std::uint64_t flawed(const result& r, flaw kind) {
  std::uint64_t sum = 0;
  for (const part_counts& c : r.parts)
    sum += c.flawed[static_cast<unsigned>(kind)];
  return sum;
}

/// The campaign on a subject reports this kind, and one trial alone shows it again.
void reports(const subject& s, flaw kind, std::uint64_t trials = 2000) {
  const result r = campaign(s, trials);
  INFO(name_of(kind));
  CHECK(flawed(r, kind) > 0);
  const auto found = std::find_if(r.findings.begin(), r.findings.end(),
                                  [kind](const finding& f) { return f.kind == kind; });
  REQUIRE(found != r.findings.end());
  const result again = campaign(s, 1, 1, found->trial);
  REQUIRE_FALSE(again.findings.empty());
  const auto same = std::find_if(again.findings.begin(), again.findings.end(),
                                 [kind](const finding& f) { return f.kind == kind; });
  REQUIRE(same != again.findings.end());
  CHECK(same->what == found->what);
}

/// The list with one operation's value changed.
subject with_change(std::vector<interval_operation> list, const std::string& name,
                    std::function<bounds(const interval_operands&, const bounds&)> change) {
  const auto at = std::find_if(list.begin(), list.end(),
                               [&](const interval_operation& o) { return o.name == name; });
  REQUIRE(at != list.end());
  at->value = [value = at->value, change](const interval_operands& o) {
    return change(o, value(o));
  };
  return subject_of("changed", "", {*at});
}

bounds one_ulp_inward(const interval_operands&, const bounds& x) {
  return x.lo < x.hi ? bounds{x.lo, std::nextafter(x.hi, -infinity)} : x;
}
bounds one_ulp_outward(const interval_operands&, const bounds& x) {
  return {x.lo, std::nextafter(x.hi, infinity)};
}

subject subject_of(part p) { return {"one", "", {std::move(p)}}; }

} // namespace

TEST_CASE("fuzz.self: nothing is found on what is shipped", "[property][mpfr]") {
  for (const subject& s : subjects()) {
    CAPTURE(s.name);
    const result r = campaign(s, s.name == "voxelizer" ? 600 : 4000);
    CHECK(r.findings.empty());
    for (const part_counts& c : r.parts)
      CHECK(c.trials > 0);
  }
}

TEST_CASE("fuzz.self: every function of intervals has a judge", "[unit]") {
  std::vector<std::string> parts;
  for (const char* name : {"intervals", "functions"})
    for (const part& p : find_subject(name)->parts)
      parts.push_back(p.name);
#define GRAZE_NAME(name) #name,
  for (const char* name : {GRAZE_FOR_EACH_FUNCTION(GRAZE_NAME)}) {
    CAPTURE(name);
    CHECK(std::count(parts.begin(), parts.end(), name) == 1);
  }
#undef GRAZE_NAME
}

TEST_CASE("fuzz.self: a broken operation of intervals is reported", "[unit]") {
  for (const char* name : {"add", "mul", "div", "fma", "sqr_rev", "mul_rev", "sin_rev",
                           "interval<nearest>", "boost<upward>"}) {
    CAPTURE(name);
    reports(with_change(interval_operations(), name, one_ulp_inward), flaw::unsound, 500);
    reports(with_change(interval_operations(), name, one_ulp_outward), flaw::loose, 500);
  }
  for (const char* name : {"exp", "sin", "tan", "atan2", "pow", "pown", "cot"}) {
    CAPTURE(name);
    reports(with_change(elementary_operations(), name, one_ulp_inward), flaw::unsound, 500);
    reports(with_change(elementary_operations(), name, one_ulp_outward), flaw::loose, 500);
  }
  // the first root of a negative number is no member; [-1, 0] has one
  reports(with_change(interval_operations(), "sqrt",
                      [](const interval_operands& o, const bounds& r) {
                        return o.boxes[0].hi == 0 ? bounds::empty() : r;
                      }),
          flaw::wrong_empty);
  reports(with_change(interval_operations(), "upward points",
                      [](const interval_operands&, const bounds& r) {
                        return r.lo == 0 ? bounds{0, 0} : r; // the zero's sign is lost
                      }),
          flaw::difference);
}

TEST_CASE("fuzz.self: how many ulps a bound is wide", "[unit]") {
  observations seen;
  compare("f", {1, 2}, {std::nextafter(1, 0), 2}, seen);
  compare("f", {-0.0, 0}, {0, 0x2p-1074}, seen);
  compare("f", {0, 1}, {-0.0, 1}, seen);
  compare("f", bounds::empty(), bounds::empty(), seen);
  REQUIRE(seen.size() == 2);
  CHECK(seen[0].what.find("1 and 0 ulps") != std::string::npos);
  CHECK(seen[1].what.find("0 and 2 ulps") != std::string::npos);
  seen.clear();
  compare("f", {1, 2}, {2, 1}, seen);
  compare("f", {1, infinity}, {infinity, infinity}, seen);
  compare("f", {1, 2}, bounds::empty(), seen);
  REQUIRE(seen.size() == 3);
  CHECK(seen[0].kind == flaw::unsound);
  CHECK(seen[1].kind == flaw::unsound);
  CHECK(seen[2].kind == flaw::wrong_empty);
}

TEST_CASE("fuzz.self: a broken operation over arrays is reported", "[unit]") {
  auto list = batch_operations();
  for (batch_operation& o : list)
    o.arrays = [arrays = o.arrays](auto x, auto y, auto z, batch::intervals r) {
      arrays(x, y, z, r);
      if (r.size() % 8 == 7) // the last lane of an incomplete register
        r.hi[r.size() - 1] = std::nextafter(r.hi[r.size() - 1], -infinity);
    };
  reports(subject_of(spans_by(batch::path::baseline, list)), flaw::difference);
  list = batch_operations();
  for (batch_operation& o : list)
    o.pairs = [](auto, auto, auto, std::span<bounds> r) {
      for (bounds& x : r)
        x = bounds::entire();
    };
  reports(subject_of(spans_by(batch::path::baseline, list)), flaw::difference);
}

TEST_CASE("fuzz.self: an enclosure of a formula one ulp too narrow is reported", "[unit]") {
  reports(formula_subject([](const bounds& x) {
            return x.lo < x.hi ? bounds{std::nextafter(x.lo, infinity), x.hi} : x;
          }),
          flaw::unsound, 2000);
}

TEST_CASE("fuzz.self: a dropped leaf is reported", "[unit]") {
  // every eighth leaf, by its place
  reports(voxelizer_subject([](const octree::cube& c) {
            double sum = 0;
            for (int a = 0; a < 3; ++a)
              sum += c.lo[a] / c.size;
            return std::fmod(sum, 8) == 3;
          }),
          flaw::dropped, 400);
  const result all = campaign(voxelizer_subject([](const octree::cube&) { return true; }), 400);
  CHECK(flawed(all, flaw::dropped) > 200); // so many lines meet the surface
  CHECK(flawed(all, flaw::difference) > 0);
}

TEST_CASE("fuzz.self: a loader that takes damaged bytes, or reads beyond them, is reported",
          "[unit]") {
  const auto lenient = [](std::span<const unsigned char> b) {
    // believes any checksum
    std::vector<unsigned char> copy(b.begin(), b.end());
    auto r = octree::decode_octree(copy);
    if (!r && r.reason().find("checksum") != std::string::npos)
      return expected<octree::described_octree>(*octree::decode_octree(*octree::encode_octree(
          *octree::sparse_octree::from_arrays(*octree::root_cube::make({{}, 1}, 1), {1}, {0},
                                              {octree::content::possible}),
          "")));
    return r;
  };
  reports(subject_of(octree_file_loader("lenient", false, lenient)), flaw::accepted);
  const auto beyond = [](std::span<const unsigned char> b) {
    if (b.size() > 200 && *(b.data() + b.size()) == 1) // one too far
      return expected<octree::described_octree>(unexpected{"one"});
    return octree::decode_octree(b);
  };
  reports(subject_of(octree_file_loader("beyond", false, beyond)), flaw::crash, 40);
  const auto silent = [](std::span<const unsigned char> b) {
    auto r = octree::decode_octree(b);
    return r ? std::move(r) : expected<octree::described_octree>(unexpected{""});
  };
  reports(subject_of(octree_file_loader("silent", true, silent)), flaw::no_reason);
  const auto strict = [](std::string_view) { return expected<fuzz::trial>(unexpected{"no"}); };
  reports(subject_of(replay_line_loader("strict", strict)), flaw::meaning);
  const auto changes = [](std::string_view line) {
    auto t = fuzz::from_json_line(line);
    if (t)
      t->origin[1] += 1;
    return t;
  };
  reports(subject_of(replay_line_loader("changes", changes)), flaw::meaning);
}

#if defined(__x86_64__)
namespace {

struct forgetful : rounding::upward {
  struct scope {
    scope() { rounding::hardware::set_mxcsr(0x5f80); }
  };
};
/// Restores what it thinks is usual.
struct usual : rounding::split {
  struct scope {
    rounding::split::scope inner;
    scope() = default;
    ~scope() { rounding::hardware::set_x87_control(0x037f); } // inner then restores its own
  };
};
struct usual_at_the_end : rounding::upward {
  struct scope {
    scope() { rounding::hardware::set_mxcsr(0x5f80); }
    ~scope() { rounding::hardware::set_mxcsr(0x1f80); }
  };
};
/// Has no scope at all: bounds that a caller's mode breaks.
struct without_scope : rounding::upward {
  struct scope {
    scope() {}
  };
};
struct wide : rounding::upward {
  static double mul_up(double x, double y) {
    return std::nextafter(rounding::upward::mul_up(x, y), infinity);
  }
};

} // namespace

TEST_CASE("fuzz.self: a scope that does not restore, and bounds that do not hold, are reported",
          "[unit]") {
  reports(subject_of(backend_words<forgetful>("forgetful", callers_words::any)),
          flaw::control_word);
  reports(subject_of(backend_words<usual_at_the_end>("usual", callers_words::any)),
          flaw::control_word);
  reports(subject_of(backend_words<without_scope>("none", callers_words::any)), flaw::unsound);
  reports(subject_of(backend_words<wide>("wide", callers_words::any)), flaw::loose);
  const result fine = campaign(subject_of(backend_words<usual>("split", callers_words::any)), 500);
  CHECK(fine.findings.empty());
}
#endif

TEST_CASE("fuzz.self: a crash, an exception and a hang are findings, and the campaign goes on",
          "[unit]") {
  const subject s{"bad",
                  "",
                  {{"aborts",
                    [](std::uint64_t, std::uint64_t index, observations&) {
                      if (index == 303)
                        std::raise(SIGKILL);
                    }},
                   {"throws",
                    [](std::uint64_t, std::uint64_t index, observations&) {
                      if (index % 100 == 1)
                        throw std::runtime_error("thrown on purpose");
                    }},
                   {"fine", [](std::uint64_t, std::uint64_t, observations&) {}}}};
  for (const unsigned processes : {1u, 3u}) {
    const result r = campaign(s, 1000, processes);
    CHECK(r.parts[0].trials == 334);
    CHECK(flawed(r, flaw::crash) == 1 + 4);
    REQUIRE(r.findings.size() == 2);
    CHECK(r.findings[0].trial == 1);
    CHECK(r.findings[0].what.find("thrown on purpose") != std::string::npos);
    CHECK(r.findings[1].trial == 303);
    CHECK(r.findings[1].what.find("signal 9") != std::string::npos);
  }
  const subject endless = subject_of({"endless", [](std::uint64_t, std::uint64_t, observations&) {
                                        while (true)
                                          pause();
                                      }});
  const plan p{{.trials = 2}, &endless, 0.05};
  const auto r = run(p, never);
  REQUIRE(r);
  CHECK(r->trials == 2);
  CHECK(flawed(*r, flaw::hang) == 2);
}

TEST_CASE("fuzz.self: the same counts and findings with any number of processes", "[unit]") {
  const subject s = with_change(interval_operations(), "mul", one_ulp_inward);
  const result single = campaign(s, 3000, 1), several = campaign(s, 3000, 3);
  CHECK(single.parts[0].flawed == several.parts[0].flawed);
  REQUIRE(single.findings.size() == several.findings.size());
  for (std::size_t i = 0; i < single.findings.size(); ++i) {
    CHECK(single.findings[i].trial == several.findings[i].trial);
    CHECK(single.findings[i].what == several.findings[i].what);
  }
}

TEST_CASE("fuzz.self: what was found is kept when a campaign is stopped", "[unit]") {
  const subject s = with_change(interval_operations(), "mul", one_ulp_inward);
  std::atomic<bool> stop{false};
  const plan p{{.workers = 2}, &s};
  const auto r = run(p, stop, [&stop](std::uint64_t trials, double) { stop = trials > 500; });
  REQUIRE(r);
  CHECK(r->interrupted);
  CHECK(r->trials > 500);
  CHECK_FALSE(r->findings.empty());
  const subject nothing{"nothing", "", {}};
  const plan refused{{}, &nothing};
  CHECK_FALSE(run(refused, never));
}
