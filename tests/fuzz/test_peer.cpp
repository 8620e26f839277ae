/// A traversal behind the line protocol that is right, but for what it does on purpose when a ray's
/// direction has x < 0: test_peer BEHAVIOUR.
#include <adapters/adapter.hpp>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <traversal/list.hpp>
#include <unistd.h>

using namespace graze::fuzz;
using nlohmann::json;

namespace {

trial read_json(const std::string& line) {
  const json request = json::parse(line);
  trial t;
  t.origin = request["origin"].get<vec3>();
  t.direction = request["direction"].get<vec3>();
  for (unsigned a = 0; a < 3; ++a) // the hex spelling says the same
    if (std::strtod(request["hex"]["origin"][a].get<std::string>().c_str(), nullptr) !=
            t.origin[a] ||
        std::strtod(request["hex"]["direction"][a].get<std::string>().c_str(), nullptr) !=
            t.direction[a])
      std::abort();
  t.root = {request["root"]["lo"].get<vec3>(), request["root"]["size"].get<double>()};
  t.level = request["level"].get<int>();
  t.base = request["base"].get<std::array<std::uint64_t, 3>>();
  t.extent = request["extent"].get<std::array<std::uint8_t, 3>>();
  if (request["voxel_size"].get<double>() != t.size())
    std::abort();
  return t;
}

trial read_plain(const std::string& line) {
  std::istringstream words(line);
  trial t;
  std::uint64_t id = 0;
  words >> id >> t.level >> t.base[0] >> t.base[1] >> t.base[2];
  for (auto& e : t.extent) {
    unsigned n = 0;
    words >> n;
    e = static_cast<std::uint8_t>(n);
  }
  std::string word;
  const auto read = [&](double& x) { words >> word, x = std::strtod(word.c_str(), nullptr); };
  for (vec3* v : {&t.origin, &t.direction, &t.root.lo})
    for (double& x : *v)
      read(x);
  read(t.root.size);
  return t;
}

json answer_to(const trial& t, traversal& under_test, bool around = false) {
  visited visits;
  under_test.visit(t, visits);
  json list = json::array();
  for (unsigned i = 0; i < visits.size(); ++i) {
    const octant_number v = visits[i];
    list.push_back({t.base[0] + (v & 3u), t.base[1] + (v >> 2 & 3u), t.base[2] + (v >> 4)});
  }
  if (around && t.level > 2) // what lies around the block is nobody's business
    list.push_back(
        json::array({t.base[0] == 0 ? std::uint64_t{t.extent[0]} : 0, t.base[1], t.base[2]}));
  return list;
}

} // namespace

int main(int argc, char** argv) {
  const std::string behaviour = argc > 1 ? argv[1] : "right";
  const auto is = [&](const char* name) { return behaviour == name; };
  const auto sound = find_traversal("sound")->make();
  const auto wrong = find_traversal("mutant-drops")->make();
  std::ios::sync_with_stdio(false);
  if (is("silent"))
    pause();
  if (is("hello"))
    std::cout << R"({"promise":"owned"})" << std::endl;
  if (is("hello-plain"))
    std::cout << "promise exactly-owned" << std::endl;
  if (is("hello-wrong"))
    std::cout << R"({"promise":"the moon"})" << std::endl;
  std::cerr << "a word of the peer\n";
  std::uint64_t count = 0;
  for (std::string line; std::getline(std::cin, line); ++count) {
    const bool plain = line[0] != '{';
    trial t = plain ? read_plain(line) : read_json(line);
    const bool now = t.direction[0] < 0;
    if (plain) {
      for (const json& voxel : answer_to(t, *sound))
        for (const json& i : voxel)
          std::cout << i << ' ';
      std::cout << std::endl;
      continue;
    }
    if (now && is("exit"))
      return 3;
    if (now && is("exit-unflushed")) // answers before it are lost with it
      _exit(3);
    if (now && is("abort"))
      raise(SIGKILL);
    if (now && is("hang"))
      pause();
    if (is("once") && count == 40) // a fault that has nothing to do with a ray
      return 4;
    if (now && is("garbage")) {
      std::cout << "Segmentation fault :-(" << std::endl;
      continue;
    }
    if (now && is("endless")) {
      for (const std::string piece(1 << 20, ' ');;)
        std::cout << piece << std::flush;
    }
    if (now && is("nan")) {
      std::cout << "[[NaN,0,0]]" << std::endl;
      continue;
    }
    if (is("two-lines")) { // with ids, by which lines too many are told wherever they stand
      const json object{{"id", json::parse(line)["id"]}, {"visited", answer_to(t, *sound)}};
      std::cout << (now ? object.dump() + "\n" : std::string()) << object.dump() << std::endl;
      continue;
    }
    if (now && is("skip")) {
      std::cout << R"({"skip":true})" << std::endl;
      continue;
    }
    if (now && is("outside")) {
      std::cout << "[[-1,0,0]]" << std::endl;
      continue;
    }
    if (is("float") || is("float-silent")) {
      json received;
      for (vec3* v : {&t.origin, &t.direction})
        for (double& x : *v)
          x = adapter::to_float(x);
      const bool ray = graze::octree::ray::make(t.origin, t.direction).has_value();
      json object{{"visited", ray ? answer_to(t, *sound) : json::array()}};
      if (is("float")) {
        json spelled = json::object();
        const auto text = [](double x) {
          return std::isinf(x) ? json(x > 0 ? "inf" : "-inf") : json(x);
        };
        for (unsigned a = 0; a < 3; ++a) {
          spelled["origin"].push_back(text(t.origin[a]));
          spelled["direction"].push_back(text(t.direction[a]));
        }
        object["received"] = spelled;
      }
      std::cout << object << std::endl;
      continue;
    }
    if (is("fat")) // more than any pipe holds, both ways
      std::cout << std::string(200'000, ' ');
    std::cout << answer_to(t, now && is("drops") ? *wrong : *sound, is("around"));
    std::cout << '\n';
    if (!is("exit-unflushed") || std::cin.rdbuf()->in_avail() <= 0)
      std::cout << std::flush; // else when there is nothing more to read at once
  }
  return 0;
}
