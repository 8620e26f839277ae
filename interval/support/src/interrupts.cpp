#include <csignal>
#include <cstring>
#include <ctime>
#include <graze/support/interrupts.hpp>
#include <graze/support/output.hpp>
#include <unistd.h>

namespace graze::support {

std::atomic<bool> stop_wanted{false};
static_assert(std::atomic<bool>::is_always_lock_free); // it is set in a signal handler

namespace {

constexpr int exit_code = 130;
constexpr long patience = 700'000'000; ///< ns; the end itself takes some, and the whole a second

std::atomic<bool> signalled{false}, orderly{false};
timer_t watchdog{};
bool has_watchdog = false;

/// System calls only.
[[noreturn]] void end_at_once() {
  const char* const name = program_name();
  const char* const text = ": interrupted\n";
  if (write(STDERR_FILENO, name, std::strlen(name)) > 0) [[maybe_unused]]
    const ssize_t n = write(STDERR_FILENO, text, std::strlen(text));
  _exit(exit_code);
}

void on_signal(int) {
  if (signalled.exchange(true))
    end_at_once();
  stop_wanted.store(true, std::memory_order_relaxed);
  const itimerspec once{{0, 0}, {0, patience}};
  if (!has_watchdog || timer_settime(watchdog, 0, &once, nullptr) != 0)
    alarm(1);
}

void on_alarm(int) {
  if (!orderly.load(std::memory_order_relaxed))
    end_at_once();
}

void handle(int signal, void (*handler)(int)) {
  struct sigaction action{};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  sigaction(signal, &action, nullptr);
}

} // namespace

bool interrupted() { return signalled.load(); }
void request_stop() { stop_wanted.store(true, std::memory_order_relaxed); }
void end_is_orderly() { orderly.store(true); }

void listen_for_interrupts() {
  handle(SIGALRM, on_alarm);
  sigevent by_alarm{};
  by_alarm.sigev_notify = SIGEV_SIGNAL;
  by_alarm.sigev_signo = SIGALRM;
  has_watchdog = has_watchdog || timer_create(CLOCK_MONOTONIC, &by_alarm, &watchdog) == 0;
  struct sigaction before{};
  sigaction(SIGHUP, nullptr, &before);
  for (const int s : {SIGINT, SIGTERM, SIGHUP})
    if (s != SIGHUP || before.sa_handler != SIG_IGN)
      handle(s, on_signal);
}

void ignore_interrupts() {
  for (const int s : {SIGINT, SIGTERM, SIGHUP, SIGALRM})
    handle(s, SIG_IGN);
}

} // namespace graze::support
