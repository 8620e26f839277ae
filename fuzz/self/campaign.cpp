#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <exception>
#include <fcntl.h>
#include <fmt/format.h>
#include <graze/support/files.hpp>
#include <graze/support/interrupts.hpp>
#include <map>
#include <memory>
#include <new>
#include <optional>
#include <self/campaign.hpp>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace graze::fuzz::self {

namespace {

using clock = std::chrono::steady_clock;

double since(clock::time_point start) {
  return std::chrono::duration<double>(clock::now() - start).count();
}

/// Trials of a stretch: a part that keeps what it made for neighbouring trials makes it once.
constexpr std::uint64_t stretch_size = 256;
constexpr unsigned most_parts = 256;
/// Seconds that a trial in work is waited for after an interrupt.
constexpr double patience = 0.3;

/// Of one worker, in memory that outlives it.
struct worker_state {
  std::atomic<std::uint64_t> next{0}, end{0}; ///< what is left of its stretch
  std::atomic<std::uint64_t> at{0};           ///< 1 + the trial in work, 0: none
  std::atomic<std::uint64_t> trials[most_parts];
  std::atomic<std::uint64_t> flawed[most_parts][flaw_kinds];
};

/// Memory that forked processes share; zeroed.
template <class T> class shared_array {
public:
  template <class... Arguments>
  static std::optional<shared_array> make(std::size_t count, const Arguments&... arguments) {
    void* at =
        mmap(nullptr, count * sizeof(T), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (at == MAP_FAILED)
      return std::nullopt;
    for (std::size_t i = 0; i < count; ++i)
      new (static_cast<T*>(at) + i) T(arguments...);
    return shared_array(static_cast<T*>(at), count);
  }
  shared_array(shared_array&& other) noexcept
      : at_(std::exchange(other.at_, nullptr)), count_(other.count_) {}
  ~shared_array() {
    if (at_ != nullptr)
      munmap(at_, count_ * sizeof(T));
  }
  T& operator[](std::size_t i) { return at_[i]; }

private:
  shared_array(T* at, std::size_t count) : at_(at), count_(count) {}
  T* at_;
  std::size_t count_;
};

struct message_head {
  std::uint64_t trial;
  std::uint32_t kind, length;
};

/// A worker's life.
class worker {
public:
  worker(const plan& p, schedule& stretches, worker_state& mine, int to)
      : plan_(p), stretches_(stretches), mine_(mine), to_(to), reported_(parts().size()) {}

  void run() {
    while (!stretches_.has_ended()) {
      std::uint64_t k = mine_.next.load(std::memory_order_relaxed);
      if (k == mine_.end.load(std::memory_order_relaxed)) {
        const auto taken = stretches_.take();
        if (!taken)
          return;
        mine_.next = k = taken->begin;
        mine_.end = taken->end;
      }
      examine(plan_.first + k);
      mine_.next = k + 1;
    }
  }

private:
  [[nodiscard]] const std::vector<part>& parts() const { return plan_.under_test->parts; }

  void examine(std::uint64_t trial) {
    const std::size_t p = trial % parts().size();
    seen_.clear();
    mine_.at.store(trial + 1, std::memory_order_relaxed);
    try {
      parts()[p].examine(plan_.seed, trial, seen_);
    } catch (const std::exception& e) {
      seen_.push_back({flaw::crash, fmt::format("an exception: {}", e.what())});
    } catch (...) {
      seen_.push_back({flaw::crash, "an exception"});
    }
    unsigned kinds = 0;
    for (const observation& o : seen_) {
      const auto kind = static_cast<unsigned>(o.kind);
      if ((kinds >> kind & 1) != 0)
        continue;
      kinds |= 1u << kind;
      mine_.flawed[p][kind].fetch_add(1, std::memory_order_relaxed);
      if ((reported_[p] >> kind & 1) == 0) // a worker's trials only go up: this is its lowest
        report(trial, kind, o.what);
      reported_[p] |= 1u << kind;
    }
    mine_.trials[p].fetch_add(1, std::memory_order_relaxed);
    mine_.at.store(0, std::memory_order_relaxed);
  }

  void report(std::uint64_t trial, unsigned kind, const std::string& what) {
    const message_head head{trial, kind, static_cast<std::uint32_t>(what.size())};
    if (!support::write_all(to_, {reinterpret_cast<const char*>(&head), sizeof head}) ||
        !support::write_all(to_, what))
      _exit(3); // nobody listens
  }

  const plan& plan_;
  schedule& stretches_;
  worker_state& mine_;
  int to_;
  std::vector<unsigned> reported_; ///< of each part, the kinds
  observations seen_;
};

/// The campaign as its parent process sees it.
class supervisor {
public:
  supervisor(const plan& p, shared_array<schedule> stretches, shared_array<worker_state> states)
      : plan_(p), stretches_(std::move(stretches)), states_(std::move(states)),
        children_(p.workers) {
    for (child& c : children_)
      c.silent_since = clock::now();
  }

  expected<result> run(const std::atomic<bool>& stop, const progress_listener& progress) {
    for (std::size_t i = 0; i < children_.size(); ++i)
      if (!start(i))
        return give_up();
    double shown = 0;
    while (running() != 0) {
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
      const double now = stretches().seconds();
      if (stop.load())
        stretches().end(); // the children's copies of `stop` do not change
      if (stop.load() && !stopped_)
        stopped_ = clock::now();
      if (stopped_ && since(*stopped_) > patience)
        abandon_trials();
      for (std::size_t i = 0; i < children_.size(); ++i)
        if (!look_after(i))
          return give_up();
      if (progress && now - shown >= 0.1) {
        progress(trials(), now);
        shown = now;
      }
    }
    return finished(stop.load());
  }

private:
  struct child {
    pid_t pid = 0; ///< 0: ended
    int from = -1;
    std::string received;
    std::uint64_t last_at = 0;
    clock::time_point silent_since;
    bool hangs = false;
  };

  bool start(std::size_t i) {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0)
      return false;
    std::fflush(nullptr); // or the child's copy would be written too
    const pid_t parent = getpid();
    const pid_t pid = fork();
    if (pid < 0) {
      close(ends[0]), close(ends[1]);
      return false;
    }
    if (pid == 0) {
      support::ignore_interrupts(); // a terminal's Ctrl-C reaches all: the parent says when to end
      for (const int fatal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT})
        std::signal(fatal, SIG_DFL); // the parent tells of it, no handler of its own
      const rlimit no_core{0, 0};
      setrlimit(RLIMIT_CORE, &no_core);
      prctl(PR_SET_PDEATHSIG, SIGKILL);
      if (getppid() == parent)
        worker(plan_, stretches(), states_[i], ends[1]).run();
      _exit(0);
    }
    close(ends[1]);
    fcntl(ends[0], F_SETFL, O_NONBLOCK);
    child& c = children_[i];
    c.pid = pid;
    c.from = ends[0];
    c.received.clear();
    c.hangs = false;
    return true;
  }

  /// Trials in work count as not begun: whoever has asked for the end does not wait for them.
  void abandon_trials() {
    for (std::size_t i = 0; i < children_.size(); ++i)
      if (children_[i].pid != 0) {
        kill(children_[i].pid, SIGKILL);
        states_[i].at = 0;
      }
  }

  /// False where a process could not be started again.
  bool look_after(std::size_t i) {
    child& c = children_[i];
    if (c.pid == 0)
      return true;
    receive(c);
    const std::uint64_t at = states_[i].at.load(std::memory_order_relaxed);
    if (at == 0 || at != c.last_at) {
      c.last_at = at;
      c.silent_since = clock::now();
    } else if (!c.hangs && since(c.silent_since) >= plan_.seconds_a_trial) {
      c.hangs = true;
      kill(c.pid, SIGKILL);
    }
    int status = 0;
    if (waitpid(c.pid, &status, WNOHANG) != c.pid)
      return true;
    receive(c);
    close(c.from);
    c.pid = 0;
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0)
      return true;
    record_end(i, status);
    return stretches().has_ended() || start(i);
  }

  /// A worker that did not end by itself: the trial in work is a finding.
  void record_end(std::size_t i, int status) {
    worker_state& state = states_[i];
    const std::uint64_t at = state.at.exchange(0);
    if (at == 0 || (children_[i].hangs && at != children_[i].last_at))
      return; // between two trials, or just answered: it is done again if it was not counted
    const std::uint64_t trial = at - 1;
    const std::size_t p = trial % plan_.under_test->parts.size();
    const flaw kind = children_[i].hangs ? flaw::hang : flaw::crash;
    ++state.trials[p];
    ++state.flawed[p][static_cast<unsigned>(kind)];
    state.next = trial - plan_.first + 1;
    keep({kind, plan_.under_test->parts[p].name, trial,
          kind == flaw::hang ? fmt::format("no answer in {} s", plan_.seconds_a_trial)
          : WIFSIGNALED(status)
              ? fmt::format("signal {}: {}", WTERMSIG(status), strsignal(WTERMSIG(status)))
              : fmt::format("exit code {}", WEXITSTATUS(status))});
  }

  void receive(child& c) {
    char buffer[4096];
    ssize_t n = 0;
    while ((n = read(c.from, buffer, sizeof buffer)) > 0)
      c.received.append(buffer, static_cast<std::size_t>(n));
    message_head head{};
    while (c.received.size() >= sizeof head) {
      std::memcpy(&head, c.received.data(), sizeof head);
      if (c.received.size() - sizeof head < head.length)
        break;
      keep({static_cast<flaw>(head.kind),
            plan_.under_test->parts[head.trial % plan_.under_test->parts.size()].name, head.trial,
            c.received.substr(sizeof head, head.length)});
      c.received.erase(0, sizeof head + head.length);
    }
  }

  void keep(finding f) {
    const auto [place, is_new] = findings_.try_emplace({f.kind, f.part}, f);
    if (!is_new && f.trial < place->second.trial)
      place->second = std::move(f);
  }

  [[nodiscard]] std::size_t running() const {
    return static_cast<std::size_t>(std::count_if(children_.begin(), children_.end(),
                                                  [](const child& c) { return c.pid != 0; }));
  }
  schedule& stretches() { return stretches_[0]; }
  std::uint64_t trials() {
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < children_.size(); ++i)
      for (std::size_t p = 0; p < plan_.under_test->parts.size(); ++p)
        sum += states_[i].trials[p].load(std::memory_order_relaxed);
    return sum;
  }

  unexpected give_up() {
    const std::string why = std::strerror(errno);
    for (const child& c : children_)
      if (c.pid != 0) {
        kill(c.pid, SIGKILL);
        waitpid(c.pid, nullptr, 0);
        close(c.from);
      }
    return unexpected{"cannot start a process: " + why};
  }

  result finished(bool interrupted) {
    result r;
    r.parts.resize(plan_.under_test->parts.size());
    for (std::size_t i = 0; i < children_.size(); ++i)
      for (std::size_t p = 0; p < r.parts.size(); ++p) {
        r.parts[p].trials += states_[i].trials[p];
        for (unsigned k = 0; k < flaw_kinds; ++k)
          r.parts[p].flawed[k] += states_[i].flawed[p][k];
      }
    for (const part_counts& c : r.parts)
      r.trials += c.trials;
    for (const auto& [key, f] : findings_)
      r.findings.push_back(f);
    std::sort(r.findings.begin(), r.findings.end(), [](const finding& a, const finding& b) {
      return std::pair(a.kind, a.trial) < std::pair(b.kind, b.trial);
    });
    r.seconds = stretches().seconds();
    r.interrupted = interrupted;
    return r;
  }

  const plan& plan_;
  shared_array<schedule> stretches_;
  shared_array<worker_state> states_;
  std::vector<child> children_;
  std::map<std::pair<flaw, std::string>, finding> findings_;
  std::optional<clock::time_point> stopped_;
};

} // namespace

expected<result> run(const plan& p, const std::atomic<bool>& stop,
                     const progress_listener& progress) {
  if (p.under_test == nullptr || p.under_test->parts.empty() ||
      p.under_test->parts.size() > most_parts)
    return unexpected{"the subject has no parts, or more than 256"};
  if (const auto well = check(p); !well)
    return unexpected{well.reason()};
  auto stretches = shared_array<schedule>::make(1, p, stretch_size, stop);
  auto states = shared_array<worker_state>::make(p.workers);
  if (!stretches || !states)
    return unexpected{"no memory to share with processes"};
  return supervisor(p, std::move(*stretches), std::move(*states)).run(stop, progress);
}

} // namespace graze::fuzz::self
