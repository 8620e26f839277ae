#include <adapters/adapter.hpp>
#include <algorithm>
#include <external/external.hpp>
#include <external/peer_process.hpp>
#include <fmt/format.h>
#include <judge/judge.hpp>
#include <utility>

namespace graze::fuzz {

namespace {

using clock = peer_process::clock;
using outcome = peer_process::outcome;

clock::duration in_seconds(double s) {
  return std::chrono::duration_cast<clock::duration>(std::chrono::duration<double>(s));
}

/// What all processes of one command share.
struct command_plan {
  external_options options;
  std::string name, summary;
  promise promised = promise::crossed;
  double start_seconds = 0; ///< until the first answer of a process, beyond the time of a ray
};

received_ray rounded(const trial& t) {
  return {adapter::to_float(t.origin), adapter::to_float(t.direction)};
}

class external final : public traversal {
public:
  explicit external(std::shared_ptr<const command_plan> p)
      : plan_(std::move(p)), process_(plan_->options.command, plan_->options.show_errors) {}

  [[nodiscard]] std::string_view name() const override { return plan_->name; }
  [[nodiscard]] promise promises() const override { return plan_->promised; }

  void visit(const trial& t, visited& out) override { alone(t, out); }

  std::size_t visit_some(std::span<const trial> trials, std::span<visited> out) override {
    if (alone_left_ == 0 && trials.size() > 1) {
      if (const std::size_t answered = together(trials, out); answered != 0)
        return answered;
    }
    alone(trials[0], out[0]);
    if (alone_left_ != 0) {
      if (out[0].failed() != fault::none) { // here it is: the others may go together again
        suspected_ = fault::none;
        alone_left_ = 0;
      } else if (--alone_left_ == 0) {
        out[0].fail(std::exchange(suspected_, fault::none));
      }
    }
    return 1;
  }

  /// The reason why the command is none, or nothing; `hello` and the time it took are told.
  std::string probe(hello& greeting, double& seconds) {
    trial t; // through the interiors of two octants, by other numbers on each axis
    t.origin = {0.3125, 0.28125, -0.5};
    t.direction = {0.03125, 0.0625, 1};
    t.extent = {2, 2, 2};
    const auto start = clock::now();
    visited out;
    alone(t, out);
    seconds = std::chrono::duration<double>(clock::now() - start).count();
    greeting = hello_;
    if (!hello_.wrong.empty())
      return fmt::format("its promise \"{}\" is none of touched, owned, crossed, exactly-touched, "
                         "exactly-owned",
                         shown(hello_.wrong));
    switch (out.failed()) {
    case fault::none:
      return {};
    case fault::crash:
      return fmt::format("ended before it answered a first ray ({})", process_.ending());
    case fault::hang:
      return fmt::format("did not answer a first ray within {:.0f} s (does it flush its output "
                         "after every line?)",
                         seconds);
    default:
      return fmt::format("answered a first ray with what is no answer: \"{}\" (see "
                         "docs/adapters.md)",
                         shown(line_));
    }
  }

private:
  /// The beginning of what a peer has said, on one line.
  static std::string shown(std::string_view text) {
    std::string result(text.substr(0, 80));
    std::replace_if(
        result.begin(), result.end(),
        [](char c) { return static_cast<unsigned char>(c) < 32 || c == 127; }, '?');
    return text.size() > 80 ? result + "..." : result;
  }

  /// A process that listens; the fault of the one that was there. Throws cannot_ask.
  fault ready() {
    fault before = fault::none;
    if (process_.ours()) {
      if (!process_.unread())
        return fault::none;
      // it has ended since its last answer, or said what it was not asked
      line_.clear();
      const outcome o = process_.read_line(line_, clock::now());
      process_.stop();
      if (o == outcome::ended)
        before = process_.ended_well() ? fault::none : fault::crash;
      else
        before = fault::malformed;
    }
    fresh_ = true;
    process_.start();
    return before;
  }

  /// Appends the request for t. False, and declined, when it cannot be sent.
  bool request(const trial& t, visited& out) {
    out.clear();
    if (!plan_->options.as_float) {
      append_request(text_, t, next_id_++, plan_->options.format);
      return true;
    }
    out.receive(rounded(t));
    const auto sent = trial_answered(t, out);
    if (!sent)
      return out.decline(), false;
    append_request(text_, *sent, next_id_++, plan_->options.format);
    return true;
  }

  /// Waits for the answer to request `id`.
  void answer(const trial& t, std::uint64_t id, visited& out) {
    auto deadline = clock::now() +
                    in_seconds(plan_->options.seconds_a_ray + (fresh_ ? plan_->start_seconds : 0));
    for (;;) {
      switch (process_.read_line(line_, deadline)) {
      case outcome::ended:
        return out.fail(fault::crash);
      case outcome::silent:
        return out.fail(fault::hang);
      case outcome::too_long:
        return out.fail(fault::malformed);
      case outcome::line:
        break;
      }
      if (std::exchange(fresh_, false))
        if (auto greeting = read_hello(line_)) {
          hello_ = std::move(*greeting);
          deadline = clock::now() + in_seconds(plan_->options.seconds_a_ray);
          continue;
        }
      return read_answer(line_, t, id, out);
    }
  }

  /// Asks one; every fault is this one's.
  void alone(const trial& t, visited& out) {
    text_.clear();
    if (!request(t, out))
      return;
    if (const fault f = ready(); f != fault::none)
      return out.fail(f);
    process_.send(text_);
    answer(t, next_id_ - 1, out);
    switch (out.failed()) {
    case fault::none:
    case fault::not_a_number:      // an answer of one line, as it should be
      if (process_.unread_now()) { // but it says more
        process_.stop();
        out.clear(); // also where it has declined
        out.fail(fault::malformed);
      }
      break;
    case fault::hang:
      process_.stop(std::chrono::milliseconds(0));
      break;
    default:
      process_.stop();
    }
  }

  /// Asks all at once. Returns how many were answered without doubt; the others are to be asked
  /// alone.
  std::size_t together(std::span<const trial> trials, std::span<visited> out) {
    text_.clear();
    const std::uint64_t first_id = next_id_;
    for (std::size_t i = 0; i < trials.size(); ++i)
      request(trials[i], out[i]);
    if (const fault f = ready(); f != fault::none)
      return doubt(f, trials.size(), 0);
    process_.send(text_);
    std::uint64_t id = first_id;
    for (std::size_t i = 0; i < trials.size(); ++i) {
      if (out[i].declined())
        continue;
      answer(trials[i], id++, out[i]);
      if (const fault f = out[i].failed(); f != fault::none && f != fault::not_a_number)
        // no answer before one that is none can be told to be that of its ray
        return doubt(f, trials.size(), f == fault::malformed ? 0 : i);
    }
    // a line too many: no answer can be told to be that of its ray
    return process_.unread_now() ? doubt(fault::malformed, trials.size(), 0) : trials.size();
  }
  std::size_t doubt(fault f, std::size_t asked, std::size_t answered) {
    process_.stop(std::chrono::milliseconds(f == fault::hang ? 0 : 100));
    suspected_ = f == fault::hang ? fault::none : f;
    alone_left_ = asked - answered;
    return answered;
  }

  std::shared_ptr<const command_plan> plan_;
  peer_process process_;
  bool fresh_ = true; ///< the process has said nothing yet
  hello hello_;
  std::string text_, line_;
  std::uint64_t next_id_ = 0;
  std::size_t alone_left_ = 0; ///< so many are to be asked one at a time
  fault suspected_ = fault::none;
};

traversal_entry entry_of(const std::shared_ptr<const command_plan>& p, std::string options) {
  return {p->name, p->summary, [p] { return std::unique_ptr<traversal>(new external(p)); },
          std::move(options)};
}

} // namespace

std::string shell_word(std::string_view text) {
  std::string result = "'";
  for (const char c : text)
    result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

std::string spelled(const external_options& options) {
  std::string text = "--command " + shell_word(options.command);
  if (options.promised)
    text += fmt::format(" --promise {}", name_of(*options.promised));
  if (options.format == line_format::plain)
    text += " --plain";
  if (options.as_float)
    text += " --float";
  if (options.seconds_a_ray != external_options{}.seconds_a_ray)
    text += fmt::format(" --timeout {}", options.seconds_a_ray);
  return text;
}

expected<traversal_entry> external_traversal(const external_options& options) {
  const auto shared = std::make_shared<command_plan>(
      command_plan{options, options.command, "a traversal in another process", promise::crossed,
                   options.start_seconds});
  hello greeting;
  double seconds = 0;
  {
    auto first = std::make_shared<command_plan>(*shared);
    first->options.show_errors = true; // why it does not work is for the user to see
    if (std::string why = external(first).probe(greeting, seconds); !why.empty())
      return unexpected{fmt::format("the command {} {}", shell_word(options.command), why)};
  }
  shared->promised = options.promised.value_or(greeting.promised.value_or(promise::crossed));
  // others start as fast, or, on a machine that is busy, ten times slower
  shared->start_seconds = std::max(1.0, 10 * seconds);
  return entry_of(shared, spelled(options));
}

traversal_entry untried_external_traversal(const external_options& options, std::string_view name,
                                           std::string_view summary) {
  return entry_of(std::make_shared<command_plan>(command_plan{
                      options, std::string(name), std::string(summary),
                      options.promised.value_or(promise::crossed), options.start_seconds}),
                  {});
}

} // namespace graze::fuzz
