#include <adapters/adapter.hpp>
#include <algorithm>
#include <cstdio>
#include <external/external.hpp>
#include <external/peer_process.hpp>
#include <fmt/format.h>
#include <judge/judge.hpp>
#include <trial/number.hpp>
#include <unistd.h>
#include <utility>

namespace graze::fuzz {

namespace {

using clock = peer_process::clock;
using outcome = peer_process::outcome;

clock::duration in_seconds(double s) {
  return std::chrono::duration_cast<clock::duration>(std::chrono::duration<double>(s));
}

/// What all processes of one command share: the options with what it has said of itself.
struct command_plan {
  external_options options;
  std::string name, summary;
  double start_seconds = 0; ///< until the first answer of a process, beyond the time of a ray
  bool echo = false;        ///< the first request asks for the hard numbers back

  [[nodiscard]] promise promised() const { return options.promised.value_or(promise::crossed); }
  [[nodiscard]] cell_kind cells() const { return options.cells.value_or(options.usual_cells); }
  [[nodiscard]] bool segments() const { return options.segments.value_or(options.usual_segments); }
  [[nodiscard]] answer_form form() const {
    return {promised(), options.format == line_format::bits, options.needs_received};
  }
};

/// The place of the first number that came back as another; -0 as 0 is not counted.
std::optional<std::size_t> wrong_echo(const echoed& echo) {
  for (std::size_t i = 0; i < echo.numbers.size(); ++i) {
    const double sent = hard_numbers()[i], came = echo.numbers[i];
    if (bits_of(sent) != bits_of(came) && !(sent == 0 && came == 0))
      return i;
  }
  return std::nullopt;
}

std::string wrong_echo_text(const echoed& echo, std::size_t place, line_format format) {
  const double sent = hard_numbers()[place], came = echo.numbers[place];
  const bool is_ulp_off = came == step_ulps(sent, 1) || came == step_ulps(sent, -1);
  return fmt::format(
      "reads or writes doubles wrong: of \"echo\", {} (bits {}) came back as {} (bits "
      "{}); {}{} (docs/adapters.md#numbers)",
      sent, bits_of(sent), came, bits_of(came),
      format == line_format::json ? "take and give back the strings of \"bits\"" : "take --bits",
      is_ulp_off ? ", or, in Rust, serde_json's feature float_roundtrip" : "");
}

/// The beginning of what a peer has said, on one line.
std::string shown(std::string_view text, std::size_t most = 80) {
  std::string result(text.substr(0, most));
  std::replace_if(
      result.begin(), result.end(),
      [](char c) { return static_cast<unsigned char>(c) < 32 || c == 127; }, '?');
  return text.size() > most ? result + "..." : result;
}

class external final : public traversal {
public:
  explicit external(std::shared_ptr<const command_plan> p)
      : external(p, p->options.show_errors ? STDERR_FILENO : -1, false) {}
  /// To be tried, what it writes to its standard error goes to this descriptor.
  external(std::shared_ptr<const command_plan> p, int errors, bool is_tried = true)
      : plan_(std::move(p)), is_tried_(is_tried),
        process_(plan_->options.command, errors,
                 bytes_of_answer * std::max<std::size_t>(1, batch())) {}

  [[nodiscard]] std::string_view name() const override { return plan_->name; }
  [[nodiscard]] promise promises() const override { return plan_->promised(); }
  [[nodiscard]] bool takes(cell_kind cells, bool segment) const override {
    return cells == plan_->cells() && segment == plan_->segments();
  }
  [[nodiscard]] std::optional<double> tolerance() const override {
    const external_options& o = plan_->options;
    constexpr double ulp_of_float = 0x1p29; // in those of double
    return o.as_float ? o.tolerance.value_or(usual_tolerance) * ulp_of_float : o.tolerance;
  }
  [[nodiscard]] bool in_float() const override { return plan_->options.as_float; }
  [[nodiscard]] std::size_t at_once() const override { return std::max<std::size_t>(64, batch()); }

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

  /// Starts it, and waits a moment for its first line: most say it at once.
  void listen() {
    ready();
    if (process_.read_line(line_, clock::now() + in_seconds(patience)) != outcome::line)
      return;
    if (auto greeting = read_hello(line_)) {
      hello_ = std::move(*greeting);
      is_fresh_ = false;
      is_heard_ = true;
    } else { // an answer to what was not asked
      said_too_early_ = line_;
    }
  }

  /// The reason why the command is none, or nothing.
  std::string probe(const trial& t, visited& out, double& seconds) {
    if (!said_too_early_.empty())
      return fmt::format("said \"{}\" before it was asked (see docs/adapters.md)",
                         shown(said_too_early_));
    const auto start = clock::now();
    alone(t, out);
    seconds = std::chrono::duration<double>(clock::now() - start).count();
    if (!hello_.wrong.empty())
      return {};
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
      return fmt::format("answered a first ray with what is no answer: \"{}\": {} (see "
                         "docs/adapters.md)",
                         shown(line_),
                         out.failed() == fault::not_a_number ? "a NaN"
                         : out.thrown().empty()              ? "a line without end"
                                                             : out.thrown());
    }
  }
  [[nodiscard]] const hello& greeting() const { return hello_; }
  [[nodiscard]] bool is_heard() const { return is_heard_; }
  [[nodiscard]] const echoed& echo() const { return echo_; }
  void stop() { process_.stop(); }

private:
  static constexpr double patience = 0.25; ///< for a first line, in seconds
  /// No answer is as long: a voxel is 60 bytes at most, and a line through 2^16 octants is enough.
  static constexpr std::size_t bytes_of_answer = std::size_t{1} << 23;

  [[nodiscard]] std::size_t batch() const { return plan_->options.batch; }
  [[nodiscard]] bool batches_in_json() const {
    return batch() != 0 && plan_->options.format == line_format::json;
  }

  /// A process that listens; the fault of the one that was there. Throws cannot_ask.
  fault ready() {
    fault before = fault::none;
    if (process_.ours()) {
      // what one says first may come now, after listen()
      if ((is_fresh_ && is_unasked_) || !process_.unread())
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
    is_fresh_ = is_unasked_ = true;
    process_.start();
    return before;
  }

  /// Whether t can be sent; what is sent is `sent`. Else it is declined.
  bool prepare(const trial& t, trial& sent, visited& out) const {
    out.clear();
    if (!takes(t.cells(), t.end.has_value()))
      return out.decline(), false;
    sent = t;
    if (!plan_->options.as_float)
      return true;
    out.receive(rounded_to_float(t));
    const auto rounded = trial_answered(t, out);
    if (!rounded)
      return out.decline(), false;
    sent = *rounded;
    return true;
  }

  /// Sends the prepared trials of these places, and gives the first one's id.
  std::uint64_t send(std::span<const trial> prepared, std::span<const std::size_t> places) {
    const line_format format = plan_->options.format;
    const std::uint64_t first_id = next_id_;
    text_.clear();
    for (std::size_t at = 0; at < places.size();) {
      const bool is_first = std::exchange(is_unasked_, false);
      const opening first{plan_->echo && is_first, is_first};
      const std::size_t some = batch() == 0 ? 1 : std::min(batch(), places.size() - at);
      if (batch() == 0)
        append_request(text_, prepared[places[at]], next_id_, format, first);
      else
        append_batch(text_, prepared, places.subspan(at, some), next_id_, format, first);
      next_id_ += some;
      at += some;
    }
    process_.send(text_);
    return first_id;
  }

  /// Waits for a line that is not the first word. Its fault, if there is none.
  fault next_line(std::size_t requests) {
    const double seconds =
        plan_->options.seconds_a_ray * (1 + static_cast<double>(requests - 1) / 100);
    auto deadline = clock::now() + in_seconds(seconds + (is_fresh_ ? plan_->start_seconds : 0));
    for (;;) {
      switch (process_.read_line(line_, deadline)) {
      case outcome::ended:
        return fault::crash;
      case outcome::silent:
        return fault::hang;
      case outcome::too_long:
        return fault::malformed;
      case outcome::line:
        break;
      }
      if (std::exchange(is_fresh_, false))
        if (auto greeting = read_hello(line_)) {
          hello_ = std::move(*greeting);
          is_heard_ = true;
          deadline = clock::now() + in_seconds(seconds);
          continue;
        }
      return fault::none;
    }
  }

  /// Waits for the answer to request `id`.
  void answer(const trial& t, std::uint64_t id, visited& out) {
    if (const fault f = next_line(1); f != fault::none)
      return out.fail(f);
    read_answer(line_, t, id, plan_->form(), out, &echo_);
    check_echo(out);
  }
  /// Waits for the answers to the requests of a batch.
  void answers(std::span<const trial> trials, std::span<const std::size_t> places,
               std::uint64_t first_id, std::span<visited> out) {
    if (const fault f = next_line(places.size()); f != fault::none) {
      for (const std::size_t i : places)
        out[i].fail(f);
      return;
    }
    read_batch(line_, trials, places, first_id, plan_->form(), out, &echo_);
    check_echo(out[places[0]]);
  }
  /// What the command gave back when it was tried is told there; another process of it must not differ.
  void check_echo(visited& out) {
    if (!is_tried_ && std::exchange(echo_.given, false) && out.failed() == fault::none)
      if (const auto place = wrong_echo(echo_))
        out.fail_by_form(wrong_echo_text(echo_, *place, plan_->options.format));
  }

  /// Asks one; every fault is this one's.
  void alone(const trial& t, visited& out) {
    prepared_.resize(std::max<std::size_t>(prepared_.size(), 1));
    if (!prepare(t, prepared_[0], out))
      return;
    if (const fault f = ready(); f != fault::none)
      return out.fail(f);
    constexpr std::size_t first = 0;
    const std::uint64_t id = send(prepared_, {&first, 1});
    if (batches_in_json())
      answers({&t, 1}, {&first, 1}, id, {&out, 1});
    else
      answer(t, id, out);
    switch (out.failed()) {
    case fault::none:
    case fault::not_a_number:      // an answer of one line, as it should be
      if (process_.unread_now()) { // but it says more
        process_.stop();
        out.clear(); // also where it has declined
        out.fail_by_form("there is another line behind the answer");
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
    prepared_.resize(std::max(prepared_.size(), trials.size()));
    places_.clear();
    for (std::size_t i = 0; i < trials.size(); ++i)
      if (prepare(trials[i], prepared_[i], out[i]))
        places_.push_back(i);
    if (places_.empty())
      return trials.size();
    if (const fault f = ready(); f != fault::none)
      return doubt(f, trials.size(), 0);
    std::uint64_t id = send(prepared_, places_);
    const std::span<const std::size_t> all = places_;
    for (std::size_t at = 0; at < all.size();) {
      const std::size_t some = batches_in_json() ? std::min(batch(), all.size() - at) : 1;
      const auto asked = all.subspan(at, some);
      if (batches_in_json())
        answers(trials, asked, id, out);
      else
        answer(trials[asked[0]], id, out[asked[0]]);
      for (const std::size_t i : asked)
        if (const fault f = out[i].failed(); f != fault::none && f != fault::not_a_number)
          // no answer before one that is none can be told to be that of its ray
          return doubt(f, trials.size(), f == fault::malformed ? 0 : asked[0]);
      id += some;
      at += some;
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
  bool is_tried_; ///< the command is being tried
  peer_process process_;
  bool is_fresh_ = true;   ///< the process has said nothing yet
  bool is_unasked_ = true; ///< and was asked nothing
  hello hello_;
  bool is_heard_ = false;
  echoed echo_;
  std::string said_too_early_;
  std::string text_, line_;
  std::vector<trial> prepared_;
  std::vector<std::size_t> places_;
  std::uint64_t next_id_ = 0;
  std::size_t alone_left_ = 0; ///< so many are to be asked one at a time
  fault suspected_ = fault::none;
};

traversal_entry entry_of(const std::shared_ptr<const command_plan>& p, std::string options) {
  return {p->name, p->summary, [p] { return std::unique_ptr<traversal>(new external(p)); },
          std::move(options)};
}

/// To a point of an occupied voxel of the map from beside it.
trial first_trial(const std::shared_ptr<const voxel_map>& map, bool segment) {
  trial t;
  t.map = map;
  t.grid = map->grid();
  const voxel_index v = map->voxel(0);
  std::copy(v.begin(), v.end(), t.base.begin());
  vec3 inside{}, before{};
  const octree::box cell = t.cell(0);
  for (unsigned a = 0; a < 3; ++a) {
    const double edge = cell.hi[a] - cell.lo[a];
    inside[a] = cell.lo[a] + edge / 2;
    before[a] = cell.lo[a] - (a == 2 ? edge : edge / 8);
    t.direction[a] = inside[a] - before[a];
  }
  t = with_ray(t, before, t.direction);
  return segment ? with_end(t, before, inside) : t;
}

/// A ray, or a segment, through the interiors of two cells, by other numbers on each axis.
trial first_trial(cell_kind cells, bool segment) {
  trial t;
  t.origin = {0.3125, 0.28125, -0.5};
  t.direction = {0.03125, 0.0625, 1};
  t.extent = {2, 2, 2};
  if (segment) {
    t.end = {0.375, 0.40625, 1.5};
    t.direction = {0.0625, 0.125, 2};
  }
  if (cells == cell_kind::grid) {
    grid_planes grid;
    grid.spacing = {0.5, 0.5, 0.5};
    grid.count = {2, 2, 2};
    grid.rule = octree::plane_rule::multiplied; // all give the same planes
    t.grid = std::make_shared<const grid_planes>(grid);
  }
  if (cells == cell_kind::boxes)
    t.boxes = std::make_shared<const std::vector<octree::box>>(std::vector<octree::box>{
        {{0, 0, 0}, {0.5, 0.5, 0.5}}, {{0, 0, 0.5}, {0.5, 0.5, 1}}, {{0.5, 0, 0}, {1, 0.5, 1}}});
  return t;
}

/// Promises whose answers are of one form.
unsigned answers_of(promise p) {
  if (p == promise::any || p == promise::count)
    return p == promise::any ? 2 : 3;
  return p == promise::first || p == promise::first_touched ? 1 : 0;
}

/// What the options and its first line ask for together; the reason where they contradict each other.
expected<external_options> agreed(const external_options& asked, const hello& greeting) {
  external_options both = asked;
  const auto contradiction = [](std::string_view says, std::string_view option) {
    return unexpected{fmt::format("says {} in its first line, against {}", says, option)};
  };
  if (asked.promised && greeting.promised &&
      answers_of(*asked.promised) != answers_of(*greeting.promised))
    return contradiction(fmt::format("promise {}", name_of(*greeting.promised)),
                         fmt::format("--promise {}", name_of(*asked.promised)));
  if (!asked.promised)
    both.promised = greeting.promised;
  if (asked.cells && greeting.cells && asked.cells != greeting.cells)
    return contradiction(fmt::format("cells {}", name_of(*greeting.cells)),
                         fmt::format("--cells {}", name_of(*asked.cells)));
  if (!asked.cells)
    both.cells = greeting.cells;
  if (asked.segments && greeting.segments && asked.segments != greeting.segments)
    return contradiction(*greeting.segments ? "segments" : "no segments",
                         *asked.segments ? "--segments" : "the rays asked for");
  if (!asked.segments)
    both.segments = greeting.segments;
  if (greeting.batch && asked.batch > *greeting.batch)
    return contradiction(fmt::format("a batch of {} at most", *greeting.batch),
                         fmt::format("--batch {}", asked.batch));
  if (asked.batch == 0)
    both.batch = greeting.batch.value_or(0);
  if (const auto well = judgeable(both.promised.value_or(promise::crossed),
                                  both.cells.value_or(both.usual_cells));
      !well)
    return unexpected{fmt::format("cannot be judged: {}", well.reason())};
  if (!asked.tolerance)
    both.tolerance = greeting.tolerance;
  both.as_float = asked.as_float || greeting.as_float;
  if (!greeting.numbers || *greeting.numbers == asked.format)
    return both;
  constexpr std::array<const char*, 3> names{"decimal", "hex", "bits"};
  const char* numbers = names[static_cast<unsigned>(*greeting.numbers)];
  if (asked.format != line_format::json)
    return contradiction(fmt::format("numbers {}", numbers),
                         asked.format == line_format::plain ? "--plain" : "--bits");
  if (greeting.plain)
    both.format = *greeting.numbers;
  else if (*greeting.numbers == line_format::plain)
    return unexpected{
        "says numbers hex in its first line: JSON has decimals and bits, --plain has hex"};
  return both;
}

/// What it has written to its standard error so far.
void show_errors_of(external& tried, FILE& errors) {
  tried.stop();
  std::rewind(&errors);
  for (int c = std::getc(&errors); c != EOF; c = std::getc(&errors))
    std::fputc(c, stderr);
}

bool same_requests(const command_plan& p, const external_options& o, bool echo) {
  const external_options& q = p.options;
  return q.promised == o.promised && q.cells == o.cells && q.segments == o.segments &&
         q.batch == o.batch && q.format == o.format && q.as_float == o.as_float && p.echo == echo;
}

/// What is worth a line, of a traversal that answers.
std::vector<std::string> notices_of(const command_plan& p, const echoed& echo,
                                    const visited& first) {
  std::vector<std::string> all;
  if (!echo.given)
    all.emplace_back(
        p.options.format == line_format::json
            ? "it gave no \"echo\" back: whether it reads doubles exactly was not checked "
              "(docs/adapters.md#numbers)"
            : "whether it reads doubles exactly was not checked: its first line has no "
              "\"echo true\" (docs/adapters.md#numbers)");
  else if (!echo.sign_of_zero)
    all.emplace_back("of \"echo\", -0 came back as 0: what a traversal does on -0 may not be seen "
                     "(docs/adapters.md#numbers)");
  if (answers_of(p.promised()) == 0 && first.size() == 1 && !first.declined() && !p.options.map)
    all.emplace_back(
        "it named one of the two cells that the first ray crosses: one that gives the first "
        "hit only says so, promise first (docs/adapters.md#what-it-promises)");
  return all;
}

} // namespace

std::string first_request(const trial& t, const external_options& options) {
  trial sent = t;
  if (options.as_float) {
    visited rounded;
    rounded.receive(rounded_to_float(t));
    sent = trial_answered(t, rounded).value_or(t);
  }
  std::string text;
  constexpr std::size_t first = 0;
  const opening told{options.echo, true};
  if (options.batch == 0)
    append_request(text, sent, 0, options.format, told);
  else
    append_batch(text, {&sent, 1}, {&first, 1}, 0, options.format, told);
  return text;
}

received_ray rounded_to_float(const trial& t) {
  received_ray r{adapter::to_float(t.origin), adapter::to_float(t.direction)};
  if (t.end) {
    r.end = adapter::to_float(*t.end);
    for (unsigned a = 0; a < 3; ++a)
      r.direction[a] = (*r.end)[a] - r.origin[a];
  }
  if (t.boxes) {
    std::vector<octree::box> boxes = *t.boxes;
    for (octree::box& b : boxes)
      b = {adapter::to_float(b.lo), adapter::to_float(b.hi)};
    r.boxes = std::make_shared<const std::vector<octree::box>>(std::move(boxes));
  }
  return r;
}

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
  if (options.tolerance)
    text += fmt::format(" --tolerance {}", *options.tolerance);
  if (options.batch != 0)
    text += fmt::format(" --batch {}", options.batch);
  if (options.format != line_format::json)
    text += options.format == line_format::plain ? " --plain" : " --bits";
  if (options.as_float)
    text += " --float";
  if (options.needs_received)
    text += " --received";
  if (options.seconds_a_ray != external_options{}.seconds_a_ray)
    text += fmt::format(" --timeout {}", options.seconds_a_ray);
  return text;
}

expected<traversal_entry> external_traversal(const external_options& options) {
  const auto refused = [&](std::string_view why) {
    return unexpected{fmt::format("the command {} {}", shell_word(options.command), why)};
  };
  external_options now = options;
  bool echo = options.format == line_format::json;
  for (int attempt = 0; attempt < 3;
       ++attempt) { // again where its first line changes what it is asked
    auto plan = std::make_shared<command_plan>(command_plan{
        now, options.command, "a traversal in another process", options.start_seconds, echo});
    // why it does not work is for the user to see, but not what it says of requests of another form than
    // that of its first line
    const std::unique_ptr<FILE, int (*)(FILE*)> errors(std::tmpfile(), std::fclose);
    external tried(plan, errors ? fileno(errors.get()) : STDERR_FILENO);
    tried.listen();
    visited first;
    double seconds = 0;
    std::string why;
    const auto greeted = [&]() -> bool { // what it says is what it was started with
      const hello& greeting = tried.greeting();
      if (!greeting.wrong.empty()) {
        why = "is not understood: " + shown(greeting.wrong, 300);
        return true;
      }
      const auto both = agreed(options, greeting);
      if (!both) {
        why = both.reason();
        return true;
      }
      now = *both;
      echo = now.format == line_format::json || greeting.echo;
      return same_requests(*plan, now, echo);
    };
    // one that says it late has said it to the process before
    bool is_settled = (attempt > 0 && !tried.is_heard()) || greeted();
    if (is_settled && why.empty()) {
      why = tried.probe(now.map ? first_trial(now.map, plan->segments())
                                : first_trial(plan->cells(), plan->segments()),
                        first, seconds);
      std::string other = std::exchange(why, {});
      is_settled = greeted(); // the first line may have come late
      if (why.empty())
        why = std::move(other);
    }
    if (!is_settled)
      continue;
    if (errors)
      show_errors_of(tried, *errors);
    if (!why.empty())
      return refused(why);
    if (tried.echo().given)
      if (const auto place = wrong_echo(tried.echo()))
        return refused(wrong_echo_text(tried.echo(), *place, now.format));
    auto shared = std::make_shared<command_plan>(*plan);
    shared->options = now;
    shared->options.show_errors = options.show_errors;
    // others start as fast, or, on a machine that is busy, ten times slower
    shared->start_seconds = std::max(1.0, 10 * seconds);
    shared->options.echo = shared->echo;
    traversal_entry entry = entry_of(shared, spelled(options));
    entry.external = std::shared_ptr<const external_options>(shared, &shared->options);
    for (const std::string& notice : notices_of(*shared, tried.echo(), first))
      entry.notices.push_back(
          fmt::format("the command {}: {}", shell_word(options.command), notice));
    return entry;
  }
  return refused("says another first line each time");
}

traversal_entry untried_external_traversal(const external_options& options, std::string_view name,
                                           std::string_view summary) {
  return entry_of(std::make_shared<command_plan>(command_plan{
                      options, std::string(name), std::string(summary), options.start_seconds}),
                  {});
}

} // namespace graze::fuzz
