#include <algorithm>
#include <campaign/schedule.hpp>
#include <graze/support/threads.hpp>

namespace graze::fuzz {

std::optional<stretch> schedule::take() {
  if (has_ended())
    return std::nullopt;
  const std::uint64_t begin = next_.fetch_add(size_);
  if (trials_ == 0)
    return stretch{begin, begin + size_};
  if (begin >= trials_)
    return std::nullopt;
  return stretch{begin, std::min(begin + size_, trials_)};
}

void run_on_threads(schedule& stretches, unsigned threads, const std::function<void()>& body,
                    const progress_listener& progress) {
  support::thread_group workers(threads, body, [&stretches] { stretches.end(); });
  while (!workers.wait_for(std::chrono::milliseconds(100)))
    if (progress)
      progress(stretches.done(), stretches.seconds());
  workers.join();
}

} // namespace graze::fuzz
