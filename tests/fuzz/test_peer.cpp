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
#include <trial/number.hpp>
#include <unistd.h>

using namespace graze::fuzz;
using nlohmann::json;

namespace {

/// Doubles said again as 16 hex digits, in the same structure.
void check_bits(const json& decimals, const json& bits) {
  if (bits.is_string()) {
    const auto x = number_of_bits(bits.get<std::string>());
    if (!x || bits_of(*x) != bits_of(decimals.get<double>()))
      std::abort();
    return;
  }
  for (const auto& member : bits.items())
    check_bits(bits.is_object() ? decimals[member.key()] : decimals[std::stoul(member.key())],
               member.value());
}

trial read_json(const json& request) {
  check_bits(request, request["bits"]);
  trial t;
  t.origin = request["origin"].get<vec3>();
  t.direction = request["direction"].get<vec3>();
  t.root = {request["root"]["lo"].get<vec3>(), request["root"]["size"].get<double>()};
  t.level = request["level"].get<int>();
  t.base = request["base"].get<std::array<std::uint64_t, 3>>();
  t.extent = request["extent"].get<std::array<std::uint8_t, 3>>();
  if (request["voxel_size"].get<double>() != t.size())
    std::abort();
  return t;
}

trial read_plain(const std::string& line, json& echo) {
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
  const auto read = [&](double& x) {
    words >> word;
    x = number_of_bits(word).value_or(std::strtod(word.c_str(), nullptr));
  };
  for (vec3* v : {&t.origin, &t.direction, &t.root.lo})
    for (double& x : *v)
      read(x);
  read(t.root.size);
  if (words >> word) // "echo"
    while (words >> word)
      echo.push_back(word);
  return t;
}

/// Digits times a power of ten, both in double: an ulp off for one in six (serde_json without
/// float_roundtrip).
double digits_times_power(std::string text) {
  int exponent = 0;
  if (const auto e = text.find('e'); e != std::string::npos) {
    exponent = std::stoi(text.substr(e + 1));
    text.resize(e);
  }
  if (text.ends_with(".0"))
    text.resize(text.size() - 2);
  const bool negative = text[0] == '-';
  if (negative)
    text.erase(0, 1);
  if (const auto point = text.find('.'); point != std::string::npos) {
    exponent -= static_cast<int>(text.size() - point - 1);
    text.erase(point, 1);
  }
  double x = static_cast<double>(std::stoull(text));
  for (; exponent < -308; exponent += 308)
    x /= 1e308;
  x = exponent < 0 ? x / std::pow(10.0, -exponent) : x * std::pow(10.0, exponent);
  return negative ? -x : x;
}

/// The hard numbers as a bad reader or writer gives them back, in JSON.
std::string echo_of(const std::string& line, const std::string& behaviour) {
  const auto from = line.find("\"echo\":[") + 8;
  std::istringstream words(line.substr(from, line.find(']', from) - from));
  std::string text;
  for (std::string word; std::getline(words, word, ',');) {
    text += text.empty() ? "[" : ",";
    char number[64];
    double x = std::strtod(word.c_str(), nullptr);
    if (behaviour == "reads-an-ulp-off")
      x = digits_times_power(word);
    if (behaviour == "reads-floats")
      x = adapter::to_float(x);
    if (behaviour == "loses-the-sign" && x == 0)
      x = 0;
    std::snprintf(number, sizeof number, behaviour == "writes-six-digits" ? "%g" : "%.17g", x);
    text += std::isfinite(x) ? number : "null";
  }
  return text + "]";
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
  if (is("hello-bits"))
    std::cout << "promise owned numbers bits echo true" << std::endl;
  if (is("hello-batch") || is("batch-short"))
    std::cout << R"({"promise":"owned","batch":100})" << std::endl;
  if (is("hello-plain-batch"))
    std::cout << "promise owned numbers hex batch 7" << std::endl;
  if (is("hello-unknown"))
    std::cout << R"({"promise":"owned","speed":3})" << std::endl;
  if (is("hello-first"))
    std::cout << R"({"promise":"first","tolerance":4,"segments":false})" << std::endl;
  if (is("hello-late")) {
    usleep(600'000);
    std::cout << "promise owned numbers bits" << std::endl;
  }
  std::cerr << "a word of the peer\n";
  std::uint64_t count = 0;
  for (std::string line; std::getline(std::cin, line); ++count) {
    if (line.starts_with("batch "))
      continue; // so many lines follow, each is answered by a line
    const bool plain = line[0] != '{';
    const json request = plain ? json() : json::parse(line);
    if (request.contains("batch")) {
      json answers = json::array();
      for (const json& one : request["batch"]) {
        answers.push_back({{"id", one["id"]}, {"visited", answer_to(read_json(one), *sound)}});
        if (one.contains("echo"))
          answers.back()["echo"] = one["echo"];
      }
      if (is("batch-short") && answers.size() > 20)
        answers.erase(answers.size() - 1);
      std::cout << json{{"answers", answers}} << std::endl;
      continue;
    }
    json echo;
    trial t = plain ? read_plain(line, echo) : read_json(request);
    const bool now = t.direction[0] < 0;
    if (plain) {
      for (const json& voxel : answer_to(t, *sound))
        for (const json& i : voxel)
          std::cout << i << ' ';
      if (!echo.empty())
        std::cout << "echo ";
      for (const json& word : echo)
        std::cout << word.get<std::string>() << ' ';
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
      const json object{{"id", request["id"]}, {"visited", answer_to(t, *sound)}};
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
    if (is("unit-silent")) {
      const double length =
          std::sqrt(t.direction[0] * t.direction[0] + t.direction[1] * t.direction[1] +
                    t.direction[2] * t.direction[2]);
      for (double& d : t.direction)
        d /= length;
      const bool ray = graze::octree::ray::make(t.origin, t.direction).has_value();
      std::cout << (ray ? answer_to(t, *sound) : json{{"skip", true}}) << std::endl;
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
    const json answer = answer_to(t, now && is("drops") ? *wrong : *sound, is("around"));
    if (request.contains("echo") && !is("no-echo"))
      std::cout << "{\"visited\":" << answer << ",\"echo\":" << echo_of(line, behaviour)
                << (is("misspells") ? ",\"visted\":[]}" : "}");
    else
      std::cout << answer;
    std::cout << '\n';
    if (!is("exit-unflushed") || std::cin.rdbuf()->in_avail() <= 0)
      std::cout << std::flush; // else when there is nothing more to read at once
  }
  return 0;
}
