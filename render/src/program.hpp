#pragma once
/// What graze-render and graze-voxelize share: exit codes, interrupts.
#include <atomic>

namespace graze::render {

enum exit_code { done = 0, failed = 1, bad_input = 2, interrupted = 130 };

/// Set by the first SIGINT or SIGTERM after listen_for_interrupts().
extern std::atomic<bool> stop_wanted;

/// The first signal asks for an orderly end, the second ends at once.
void listen_for_interrupts();

} // namespace graze::render
