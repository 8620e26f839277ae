// What holds for modes in threads and in signal handlers; docs/numerics.md says it.
#include <array>
#include <atomic>
#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <graze/interval.hpp>
#include <graze/rounding/environment.hpp>
#include <graze/rounding/split.hpp>
#include <graze/rounding/upward.hpp>
#include <pthread.h>
#include <string>
#include <thread>

namespace rounding = graze::rounding;

namespace {

/// The third that every backend must find.
template <class I> bool right() {
  volatile double one = 1, three = 3;
  const I third = I(one) / I(three);
  const I product = third * I(three);
  return third.lower() == 0x1.5555555555555p-2 && third.upper() == 0x1.5555555555556p-2 &&
         product.lower() == 0x1.fffffffffffffp-1 && product.upper() == 0x1.0000000000001p+0;
}

template <class B> void compute_beside_others(std::atomic<int>& ready, long& wrong) {
  const typename B::scope scope;
  for (++ready; ready < 3;) { // all three at once
  }
  for (int i = 0; i < 200'000; ++i)
    wrong += !right<graze::unprotected<B>>();
}

std::atomic<int> handled{0}, wrong_in_handler{0};
std::atomic<unsigned> mode_in_handler{0};

void handle(int) {
  mode_in_handler = rounding::hardware::mxcsr() & rounding::hardware::mxcsr_rounding;
  wrong_in_handler += !right<graze::interval<>>();
  const rounding::split::scope scope; // both control words
  wrong_in_handler += !right<graze::unprotected<rounding::split>>();
  ++handled;
}

} // namespace

TEST_CASE("interval.threads: each has its own mode", "[property]") {
  std::atomic<int> ready{0};
  std::array<long, 3> wrong{};
  std::thread up([&] { compute_beside_others<rounding::upward>(ready, wrong[0]); });
  std::thread split([&] { compute_beside_others<rounding::split>(ready, wrong[1]); });
  compute_beside_others<rounding::nearest>(ready, wrong[2]);
  up.join(), split.join();
  CHECK(wrong[0] == 0);
  CHECK(wrong[1] == 0);
  CHECK(wrong[2] == 0);
}

TEST_CASE("interval.threads: one that starts within a scope starts in its mode", "[property]") {
  // as POSIX has it; why `nearest` needs its threads to be started outside of scopes
  std::string refused;
  bool upward_right = false;
  {
    const rounding::upward::scope scope;
    std::thread t([&] {
      refused = rounding::refusal_for_nearest().value_or("");
      upward_right = right<graze::unprotected<rounding::upward>>();
    });
    t.join();
  }
  CHECK(refused.find("not to-nearest") != std::string::npos);
  CHECK(upward_right);
}

TEST_CASE(
    "interval.signals: a handler has a mode of its own, and the scope that it interrupts goes on",
    "[property]") {
  struct sigaction action = {}, before = {};
  action.sa_handler = handle;
  action.sa_flags = SA_RESTART;
  REQUIRE(sigaction(SIGUSR1, &action, &before) == 0);
  std::atomic<bool> done{false};
  const pthread_t target = pthread_self();
  std::thread sender([&] { // the signals fall anywhere in the work
    while (!done) {
      pthread_kill(target, SIGUSR1);
      std::this_thread::sleep_for(std::chrono::microseconds(50));
    }
  });
  long wrong = 0;
  {
    const rounding::upward::scope scope;
    while (handled < 100)
      wrong += !right<graze::unprotected<rounding::upward>>();
  }
  {
    const rounding::split::scope scope;
    while (handled < 200)
      wrong += !right<graze::unprotected<rounding::split>>();
  }
  done = true;
  sender.join();
  CHECK(sigaction(SIGUSR1, &before, nullptr) == 0);
  CHECK(handled >= 200);
  CHECK(wrong == 0);
  CHECK(wrong_in_handler == 0);
  CHECK(mode_in_handler == 0); // to nearest: the system gives a handler the initial control words
}
