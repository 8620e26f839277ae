#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <ctime>
#include <external/peer_process.hpp>
#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace graze::fuzz {

namespace {

void close_end(int& end) {
  if (end >= 0)
    close(end);
  end = -1;
}

/// A peer may end while it is written to: that must not end us. Only this thread's mask is touched.
class without_sigpipe {
public:
  without_sigpipe() {
    sigemptyset(&pipe_);
    sigaddset(&pipe_, SIGPIPE);
    pthread_sigmask(SIG_BLOCK, &pipe_, &before_);
  }
  ~without_sigpipe() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  without_sigpipe(const without_sigpipe&) = delete;
  without_sigpipe& operator=(const without_sigpipe&) = delete;
  /// Takes the signal that a failed write has raised.
  void take() const {
    const timespec now{};
    if (sigismember(&before_, SIGPIPE) == 0)
      sigtimedwait(&pipe_, nullptr, &now);
  }

private:
  sigset_t pipe_, before_;
};

/// A process of ours that kills the groups of peers that are left when this process ends, however
/// that ends: only the end of this process closes the pipe to it.
class keeper {
public:
  /// Starts it, once.
  static keeper& of_this_process() {
    static keeper keeps;
    return keeps;
  }
  void watch(pid_t group) const { send(group); }
  /// Before the group's number can be another's.
  void forget(pid_t group) const { send(-group); }

private:
  keeper() {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0)
      throw cannot_ask(cannot("make a pipe"));
    const pid_t pid = fork();
    if (pid < 0) {
      const std::string why = cannot("start a process");
      close(ends[0]), close(ends[1]);
      throw cannot_ask(why);
    }
    if (pid == 0) {
      dup2(ends[0], STDIN_FILENO);
      keep_until_the_end();
    }
    close(ends[0]);
    to_ = ends[1];
  }
  static std::string cannot(const char* what) {
    return fmt::format("cannot {} for the traversal: {}", what, std::strerror(errno));
  }

  void send(pid_t group) const { // less than PIPE_BUF: whole
    while (write(to_, &group, sizeof group) < 0 && errno == EINTR) {
    }
  }

  /// System calls only: there may be other threads.
  [[noreturn]] static void keep_until_the_end() {
    setsid(); // a terminal's Ctrl-C is not for this one
    for (int other = 1; other < 1024; ++other)
      close(other);
    for (const int s : {SIGINT, SIGTERM, SIGHUP, SIGPIPE})
      std::signal(s, SIG_IGN);
    static pid_t groups[4096];
    pid_t group = 0;
    for (ssize_t n = 1; n > 0 || (n < 0 && errno == EINTR);) {
      n = read(STDIN_FILENO, &group, sizeof group);
      if (n != sizeof group)
        continue;
      for (pid_t& g : groups)
        if (g == (group > 0 ? 0 : -group)) {
          g = group > 0 ? group : 0;
          break;
        }
    }
    for (const pid_t g : groups)
      if (g > 0)
        kill(-g, SIGKILL);
    _exit(0);
  }

  int to_ = -1;
};

/// The child's part between fork and exec: system calls only.
[[noreturn]] void become(const char* command, int in, int out, int errors, pid_t parent,
                         const keeper& k) {
  setpgid(0, 0);
  k.watch(getpid());
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent)
    _exit(127);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  for (const int s : {SIGPIPE, SIGINT, SIGTERM, SIGHUP, SIGALRM, SIGXFSZ})
    std::signal(s, SIG_DFL);
  dup2(in, STDIN_FILENO);
  dup2(out, STDOUT_FILENO);
  if (errors < 0)
    errors = open("/dev/null", O_WRONLY);
  if (errors >= 0 && errors != STDERR_FILENO)
    dup2(errors, STDERR_FILENO);
  execl("/bin/sh", "sh", "-c", command, static_cast<char*>(nullptr));
  _exit(127);
}

} // namespace

void peer_process::start() {
  stop();
  const keeper& k = keeper::of_this_process();
  // close-on-exec: a peer of another thread that held our end would keep this one from seeing its
  // input end
  int in[2] = {-1, -1}, out[2] = {-1, -1};
  const bool piped = pipe2(in, O_CLOEXEC) == 0 && pipe2(out, O_CLOEXEC) == 0;
  const pid_t parent = getpid();
  pid_ = piped ? fork() : -1;
  if (pid_ == 0)
    become(command_.c_str(), in[0], out[1], errors_, parent, k);
  const int error = errno;
  close_end(in[0]);
  close_end(out[1]);
  to_ = in[1];
  from_ = out[0];
  if (pid_ < 0) {
    close_end(to_), close_end(from_);
    throw cannot_ask(fmt::format("cannot start the traversal's command: {}", std::strerror(error)));
  }
  setpgid(pid_, pid_); // here too: whichever comes first
  fcntl(to_, F_SETFL, O_NONBLOCK);
  fcntl(from_, F_SETFL, O_NONBLOCK);
  starter_ = std::this_thread::get_id();
  closed_ = false;
  pending_.clear();
  buffer_.clear();
  read_ = 0;
}

void peer_process::stop(std::chrono::milliseconds patience) {
  if (pid_ <= 0)
    return;
  close_end(to_);
  close_end(from_);
  // the group is killed before its leader is reaped, while nobody else can have its number
  const auto deadline = clock::now() + patience;
  bool ended = false;
  for (;;) {
    siginfo_t info{};
    ended = waitid(P_PID, static_cast<id_t>(pid_), &info, WEXITED | WNOHANG | WNOWAIT) == 0 &&
            info.si_pid == pid_;
    if (ended || clock::now() >= deadline)
      break;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  kill(-pid_, SIGKILL);
  keeper::of_this_process().forget(pid_);
  int status = 0;
  while (waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
  }
  pid_ = -1;
  ended_well_ = ended && WIFEXITED(status) && WEXITSTATUS(status) == 0;
  if (!ended)
    ending_ = "no exit";
  else if (WIFSIGNALED(status))
    ending_ = fmt::format("signal {}", WTERMSIG(status));
  else
    ending_ = fmt::format("exit code {}", WEXITSTATUS(status));
}

void peer_process::write_some() {
  const without_sigpipe guard;
  const ssize_t n = write(to_, pending_.data(), pending_.size());
  if (n > 0)
    pending_.erase(0, static_cast<std::size_t>(n));
  else if (n < 0 && errno != EAGAIN && errno != EINTR) {
    if (errno == EPIPE)
      guard.take();
    pending_.clear(); // it does not listen any more; what it has said still counts
  }
}

bool peer_process::wait_for_data(clock::time_point deadline) {
  for (;;) {
    pollfd ends[2] = {{from_, POLLIN, 0}, {to_, POLLOUT, 0}};
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - clock::now()).count();
    const int ready = poll(ends, pending_.empty() ? 1 : 2,
                           static_cast<int>(std::clamp<decltype(left)>(left, 0, 1'000'000)));
    if (ready > 0 && ends[1].revents != 0)
      write_some();
    if (ready > 0 && ends[0].revents != 0) {
      char piece[65536];
      const ssize_t n = read(from_, piece, sizeof piece);
      if (n > 0) {
        buffer_.append(piece, static_cast<std::size_t>(n));
        return true;
      }
      if (n == 0 || (errno != EAGAIN && errno != EINTR)) {
        closed_ = true;
        return true;
      }
    }
    if (clock::now() >= deadline)
      return false;
  }
}

peer_process::outcome peer_process::read_line(std::string& line, clock::time_point deadline) {
  for (std::size_t searched = read_;;) {
    if (const std::size_t end = buffer_.find('\n', searched); end != std::string::npos) {
      line.assign(buffer_, read_, end - read_);
      if (line.ends_with('\r'))
        line.pop_back();
      read_ = end + 1;
      if (read_ == buffer_.size()) {
        buffer_.clear();
        read_ = 0;
      }
      return outcome::line;
    }
    searched = buffer_.size();
    if (searched - read_ > longest_line_)
      return outcome::too_long;
    if (closed_)
      return outcome::ended;
    if (!wait_for_data(deadline))
      return outcome::silent;
  }
}

bool peer_process::unread() {
  return read_ < buffer_.size() || closed_ || wait_for_data(clock::now());
}

} // namespace graze::fuzz
