/// Campaigns that last: killed at any moment, sharded, resumed.
#include "../support/program.hpp"
#include <campaign/lasting.hpp>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <fcntl.h>
#include <nlohmann/json.hpp>
#include <sys/prctl.h>
#include <thread>

using namespace graze::fuzz;

namespace {

using support::content, support::outcome, support::scratch;

outcome call(const std::string& arguments) { return support::call(GRAZE_FUZZ, arguments); }
void refused(const std::string& arguments, const std::string& reason) {
  support::refused(GRAZE_FUZZ, arguments, reason);
}

/// What must not depend on how a campaign came to its end.
struct ending {
  std::uint64_t rays = 0;
  std::vector<counts> by_generator;
  std::set<std::uint64_t> pieces;
  std::map<std::string, std::string> findings; ///< content by file name
  friend bool operator==(const ending&, const ending&) = default;
};

ending ending_of(const std::string& folder) {
  campaign_state state;
  const auto plan = read_campaign(folder, state);
  INFO(plan.reason());
  REQUIRE(plan);
  ending e{state.total().rays, state.by_generator, state.finished, {}};
  for (const auto& entry : std::filesystem::directory_iterator(folder + "/findings"))
    e.findings[entry.path().filename()] = content(entry.path());
  CHECK(e.findings.size() == state.findings.size());
  // and each piece has one line
  const std::string lines = content(folder + "/progress.jsonl");
  CHECK(static_cast<std::size_t>(std::count(lines.begin(), lines.end(), '\n')) ==
        state.finished.size());
  return e;
}

const std::string searched = " --traversal published --level 40 --rays 80500 --piece 1000 "
                             "--seed 7 --threads 2 --generator vertex,edge-1,mid-plane";

/// A campaign in a process of its own, which ends with this one; its events are in a pipe that holds
/// little, so that it cannot run far ahead of who reads them, and does not end unread.
class started_campaign {
public:
  explicit started_campaign(const std::string& folder, const std::string& plan) {
    int ends[2];
    REQUIRE(pipe(ends) == 0);
    (void)fcntl(ends[1], F_SETPIPE_SZ, 4096);
    child_ = fork();
    if (child_ == 0) {
      prctl(PR_SET_PDEATHSIG, SIGKILL);
      dup2(ends[1], STDOUT_FILENO);
      close(ends[0]);
      const std::string command =
          "exec '" GRAZE_FUZZ "' campaign '" + folder + "'" + plan + " --json 2>/dev/null";
      execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
      _exit(127);
    }
    close(ends[1]);
    REQUIRE(child_ > 0);
    events_ = fdopen(ends[0], "r");
    REQUIRE(events_ != nullptr);
  }
  ~started_campaign() {
    std::fclose(events_);
    if (child_ > 0) {
      kill(child_, SIGKILL);
      waitpid(child_, nullptr, 0);
    }
  }
  started_campaign(const started_campaign&) = delete;
  started_campaign& operator=(const started_campaign&) = delete;

  /// Reads events until so many pieces were finished in this start; false if it ends before.
  bool read_pieces(std::size_t pieces) {
    char* line = nullptr;
    std::size_t room = 0;
    while (pieces > 0 && getline(&line, &room, events_) > 0)
      pieces -=
          std::string_view(line).find("\"event\":\"piece\"") != std::string_view::npos ? 1 : 0;
    std::free(line);
    return pieces == 0;
  }
  /// Sends the signal; how it ended.
  int ended_by(int signal) {
    kill(child_, signal);
    char rest[4096]; // what it still says
    while (std::fread(rest, 1, sizeof rest, events_) > 0) {
    }
    int status = 0;
    REQUIRE(waitpid(child_, &status, 0) == child_);
    child_ = 0;
    return status;
  }

private:
  pid_t child_ = 0;
  std::FILE* events_ = nullptr;
};

} // namespace

TEST_CASE("graze-fuzz campaign: killed ten times, it ends as if undisturbed", "[property]") {
  const scratch dir;
  // more pieces than ten starts can finish: a pipe holds the events of ten or so that are not read
  const std::string longer = " --traversal published --level 40 --rays 240500 --piece 1000 "
                             "--seed 7 --threads 2 --generator vertex,edge-1,mid-plane";
  CHECK(call("campaign " + (dir / "undisturbed") + longer).code == 1);
  const ending undisturbed = ending_of(dir / "undisturbed");
  CHECK(undisturbed.rays == 240'500);
  CHECK(undisturbed.pieces.size() == 241);
  CHECK_FALSE(undisturbed.findings.empty());

  random_stream random(2026, 6);
  int kills = 0;
  for (std::size_t i = 0; i < 10; ++i) {
    started_campaign campaign(dir / "killed", longer);
    CHECK(campaign.read_pieces(i == 0 ? 0 : 4)); // at once, or in the middle
    // and at any moment of what it does next; how far it comes in this time is no matter
    std::this_thread::sleep_for(std::chrono::microseconds(random.below(i < 3 ? 5'000 : 30'000)));
    const int status = campaign.ended_by(SIGKILL);
    kills += WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL ? 1 : 0;
  }
  CHECK(kills == 10);
  campaign_state before; // of a kill between a finding and its line, the finding may be there alone
  REQUIRE(std::filesystem::exists(dir / "killed/plan.json"));
  REQUIRE(read_campaign(dir / "killed", before));
  CHECK(before.total().rays >= 9 * 4 * 500);
  CHECK(before.total().rays < undisturbed.rays);
  INFO("rays before the last start: " << before.total().rays);
  CHECK(call("campaign " + (dir / "killed") + longer).code == 1);
  CHECK(ending_of(dir / "killed") == undisturbed);
  CHECK(content(dir / "killed/summary.html").find("</html>") != std::string::npos);
}

TEST_CASE("graze-fuzz campaign: a line that was cut off is as if never written", "[unit]") {
  const scratch dir;
  const std::string folder = dir / "campaign", progress = folder + "/progress.jsonl";
  CHECK(call("campaign " + folder + searched).code == 1);
  const ending whole = ending_of(folder);
  const std::string lines = content(progress);
  const std::size_t last = lines.rfind('\n', lines.size() - 2) + 1;
  for (const std::size_t cut : {last + 1, (last + lines.size()) / 2, lines.size() - 1}) {
    // not a cut of what the last start wrote, whose times have other digits
    std::ofstream(progress) << lines.substr(0, cut);
    campaign_state state;
    REQUIRE(read_campaign(folder, state));
    CHECK(state.finished.size() == 80);
    const outcome o = call("campaign " + folder);
    CHECK(o.code == 1);
    CHECK(o.out.find("goes on after") != std::string::npos);
    CHECK(ending_of(folder) == whole);
  }
  // a whole line that is wrong is not passed over
  std::ofstream(progress) << lines.substr(0, last) << "{\"piece\":\n" << lines.substr(last);
  refused("campaign " + folder, "progress.jsonl:81: not JSON");
  std::ofstream(progress) << "{\"piece\":81,\"elapsed\":0,\"counts\":[],\"findings\":[]}\n";
  refused("campaign " + folder, "progress.jsonl:1: piece 81 is not of this plan");
  std::ofstream(progress) << "{\"piece\":0,\"elapsed\":0,\"counts\":[],\"findings\":[]}\n";
  refused("summary " + folder, "progress.jsonl:1: its counts are not of this plan");
  // a line that is there twice counts once
  std::ofstream(progress) << lines << lines;
  campaign_state state;
  REQUIRE(read_campaign(folder, state));
  CHECK(state.total().rays == whole.rays);
}

TEST_CASE("graze-fuzz campaign: another plan is refused with what differs", "[unit]") {
  const scratch dir;
  const std::string folder = dir / "campaign", other = dir / "other";
  CHECK(call("campaign " + folder + " --rays 2000 --seed 3 --generator vertex").code == 0);
  const auto plan = content(folder + "/plan.json");
  refused("campaign " + folder + " --seed 4", "holds another plan: seed is 3, not 4");
  refused("campaign " + folder + " --traversal plain --rays 1",
          "traversal is \"sound\", not \"plain\"; rays is 2000, not 1");
  refused("campaign " + folder + " --shard 2/3", "shard is 1, not 2; shards is 1, not 3");
  refused("campaign " + folder + " --generator all", "generators is [\"vertex\"], not [");
  CHECK(content(folder + "/plan.json") == plan);
  CHECK(call("campaign " + folder).code == 0);
  CHECK(call("campaign " + folder + " --seed 3 --threads 3").code == 0);

  CHECK(call("campaign " + other + " --rays 2000 --seed 4 --generator vertex").code == 0);
  refused("summary " + folder + " " + other + " --html " + (dir / "page.html"),
          "is not of the same campaign");
  CHECK_FALSE(std::filesystem::exists(dir / "page.html"));
}

TEST_CASE("graze-fuzz campaign: bad input is one line, exit code 2, and leaves no folder",
          "[unit]") {
  const scratch dir;
  const std::string folder = dir / "campaign";
  refused("campaign", "folder");
  refused("campaign " + folder + " --traversal nobody", "no traversal is called \"nobody\"");
  refused("campaign " + folder + " --generator nothing", "no generator is called \"nothing\"");
  refused("campaign " + folder + " --level 54", "level 54 is outside 1..53");
  for (const char* shard : {"0/1", "2/1", "1", "1/", "/1", "1/0", "-1/2", "1/2/3", "x"})
    refused("campaign " + folder + " --shard=" + shard, "is not i/N");
  refused("campaign " + folder + " --piece 0", "--piece");
  refused("campaign " + folder + " --rays -1", "--rays");
  refused("campaign " + folder + " --seconds nan", "--seconds");
  refused("campaign " + folder + " --threads 0", "--threads");
  CHECK(dir.empty());
  refused("campaign /no/such/folder --rays 1", "cannot make the folder '/no/such/folder'");
  refused("summary " + folder, "it has no plan.json");
  std::ofstream(dir / "mine.txt") << "mine";
  refused("campaign " + (dir / ""), "has no plan.json and is not empty");
  std::ofstream(dir / "plan.json") << "{}";
  refused("campaign " + (dir / ""), "is not the plan of a campaign");
  CHECK(content(dir / "plan.json") == "{}");
}

TEST_CASE("graze-fuzz campaign: a folder is held by one process", "[unit]") {
  const scratch dir;
  const std::string folder = dir / "campaign";
  started_campaign campaign(folder, " --threads 1 --piece 1000");
  REQUIRE(campaign.read_pieces(1));
  refused("campaign " + folder, "is in use by another graze-fuzz");
  const int status = campaign.ended_by(SIGTERM); // told to end, it ends with its summary
  CHECK(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == 0);
  CHECK(std::filesystem::exists(folder + "/summary.html"));
}

TEST_CASE("graze-fuzz campaign: shards together are the whole, each piece once", "[property]") {
  const scratch dir;
  CHECK(call("campaign " + (dir / "whole") + searched).code == 1);
  std::string folders;
  for (const char* shard : {"1", "2", "3"}) {
    const std::string folder = dir / (std::string("shard") + shard);
    CHECK(call("campaign " + folder + searched + " --shard " + shard + "/3").code == 1);
    folders += " " + folder;
  }
  const auto json_of = [&](const std::string& folders_named) {
    const outcome o = call("summary" + folders_named + " --json --html " + (dir / "page.html"));
    CHECK(o.code == 1);
    auto object = nlohmann::json::parse(o.out);
    object.erase("seconds");
    object.erase("rays_per_second");
    for (auto& f : object["findings"])
      f.erase("file");
    return object;
  };
  const auto whole = json_of(" " + (dir / "whole"));
  CHECK(whole["rays"] == 80'500);
  CHECK(json_of(folders) == whole);
  CHECK(json_of(folders + folders + " " + (dir / "whole")) == whole);

  const std::string page = content(dir / "page.html");
  for (const char* part : {"mid-plane", "80500", "href=\"shard1/findings/"})
    CHECK(page.find(part) != std::string::npos);
  CHECK(page.find("http") == std::string::npos);
}

TEST_CASE("graze-fuzz campaign: its findings replay, and are named by their content", "[unit]") {
  const scratch dir;
  const std::string folder = dir / "campaign";
  const outcome o = call("campaign " + folder + searched + " --json");
  CHECK(o.code == 1);
  std::istringstream lines(o.out);
  std::map<std::string, int> events;
  nlohmann::json last;
  for (std::string line; std::getline(lines, line);) {
    last = nlohmann::json::parse(line);
    ++events[last["event"]];
  }
  CHECK(events["start"] == 1);
  CHECK(events["piece"] == 81);
  CHECK(events["end"] == 1);
  CHECK(last["rays"] == 80'500);
  CHECK(last["seed"] == 7);
  CHECK(last["generators"].size() == 3);
  const ending e = ending_of(folder);
  CHECK(events["finding"] == static_cast<int>(e.findings.size()));
  int replayed = 0;
  for (const auto& [name, text] : e.findings) {
    const auto object = nlohmann::json::parse(text);
    const outcome again =
        call("replay " + folder + "/findings/" + name + " --traversal published --json");
    CHECK(again.code == 1);
    CHECK(nlohmann::json::parse(again.out)["findings"][0] == object["kind"]);
    if (++replayed == 5)
      break;
  }
}

TEST_CASE("fuzz.lasting: the rays of shards add up to the plan's", "[unit]") {
  for (const std::uint64_t rays : {1u, 99u, 100u, 101u, 1000u, 1234u})
    for (const std::uint64_t shards : {1u, 2u, 3u, 7u, 20u}) {
      stored_plan p;
      p.rays = rays;
      p.piece = 100;
      p.shards = shards;
      std::uint64_t sum = 0;
      for (p.shard = 1; p.shard <= shards; ++p.shard)
        sum += p.shard_rays();
      CHECK(sum == rays);
    }
}

TEST_CASE("graze-fuzz campaign: a budget of time is that of all starts together", "[unit]") {
  const scratch dir;
  const std::string folder = dir / "campaign";
  CHECK(call("campaign " + folder + " --seconds 0.3 --piece 1000 --threads 1").code == 0);
  const std::uint64_t rays = ending_of(folder).rays;
  CHECK(rays > 0);
  CHECK(call("campaign " + folder).code == 0);
  CHECK(ending_of(folder).rays == rays);
}

TEST_CASE("graze-fuzz run: ranges of rays add up", "[unit]") {
  const auto found = [](const std::string& range) {
    const outcome o = call("run --json --traversal published --level 1-50 --seed 5 " + range);
    CHECK(o.code == 1);
    const auto object = nlohmann::json::parse(o.out);
    return std::pair(object["rays"].get<int>(), object["gaps"].get<int>());
  };
  const auto whole = found("--rays 5000"), first = found("--rays 1500"),
             rest = found("--first-ray 1500 --rays 3500");
  CHECK(first.first + rest.first == whole.first);
  CHECK(first.second + rest.second == whole.second);
  refused("run --first-ray -1", "--first-ray");
}
