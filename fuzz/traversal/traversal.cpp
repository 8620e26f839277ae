/// Traversals that throw: what they throw is their answer.
#include <exception>
#include <external/peer_process.hpp>
#include <traversal/list.hpp>

namespace graze::fuzz {

namespace {

/// For reports of one line, and JSON: printable ASCII, not too much of it.
std::string printable(std::string_view what) {
  std::string text(what.substr(0, 200));
  for (char& c : text)
    if (c < ' ' || c > '~')
      c = '?';
  return text;
}

/// Calls f; what it throws becomes the answer.
template <class F> bool guard(visited& out, const F& f) {
  std::string what;
  try {
    f();
    return true;
  } catch (const cannot_ask&) { // no fault of the traversal
    throw;
  } catch (const std::exception& e) {
    what = printable(e.what());
  } catch (...) {
    what = "not a std::exception";
  }
  out.clear();
  out.fail_by_exception(std::move(what));
  return false;
}

class made_again final : public traversal {
public:
  explicit made_again(std::function<std::unique_ptr<traversal>()> make)
      : make_(std::move(make)), now_(make_()), name_(now_->name()), promises_(now_->promises()),
        tolerance_(now_->tolerance()), at_once_(now_->at_once()) {
    for (unsigned k = 0; k < takes_.size(); ++k)
      takes_[k] = now_->takes(static_cast<cell_kind>(k / 2), k % 2 != 0);
  }
  [[nodiscard]] std::string_view name() const override { return name_; }
  [[nodiscard]] promise promises() const override { return promises_; }
  [[nodiscard]] bool takes(cell_kind cells, bool segment) const override {
    return takes_[2 * static_cast<unsigned>(cells) + (segment ? 1 : 0)];
  }
  [[nodiscard]] std::optional<double> tolerance() const override { return tolerance_; }
  [[nodiscard]] std::size_t at_once() const override { return at_once_; }

  void visit(const trial& t, visited& out) override {
    const bool well = guard(out, [&] {
      if (!now_)
        now_ = make_();
      now_->visit(t, out);
    });
    if (!well)
      now_.reset();
  }

  std::size_t visit_some(std::span<const trial> trials, std::span<visited> out) override {
    if (!takes(trials[0].cells(), trials[0].end.has_value())) {
      out[0].clear();
      out[0].decline();
      return 1;
    }
    if (now_) {
      std::size_t answered = 0;
      visited answer;
      if (guard(answer, [&] { answered = now_->visit_some(trials, out); })) {
        if (out[answered - 1].failed() == fault::exception)
          now_.reset();
        return answered;
      }
      now_.reset();
    }
    // which of them it was is found by asking the first alone
    out[0].clear();
    visit(trials[0], out[0]);
    return 1;
  }

private:
  std::function<std::unique_ptr<traversal>()> make_;
  std::unique_ptr<traversal> now_;
  std::string name_;
  promise promises_;
  std::array<bool, std::size_t{2} * cell_kinds> takes_{};
  std::optional<double> tolerance_;
  std::size_t at_once_;
};

} // namespace

std::string_view name_of(promise p) {
  switch (p) {
  case promise::touched:
    return "touched";
  case promise::owned:
    return "owned";
  case promise::exactly_touched:
    return "exactly-touched";
  case promise::exactly_owned:
    return "exactly-owned";
  case promise::first:
    return "first";
  case promise::first_touched:
    return "first-touched";
  case promise::any:
    return "any";
  case promise::count:
    return "count";
  default:
    return "crossed";
  }
}

std::optional<promise> promise_of(std::string_view name) {
  for (const promise p : {promise::touched, promise::owned, promise::crossed,
                          promise::exactly_touched, promise::exactly_owned, promise::first,
                          promise::first_touched, promise::any, promise::count})
    if (name_of(p) == name)
      return p;
  return std::nullopt;
}

std::size_t traversal::visit_some(std::span<const trial> trials, std::span<visited> out) {
  for (std::size_t i = 0; i < trials.size(); ++i) {
    ask(*this, trials[i], out[i]);
    if (out[i].failed() == fault::exception)
      return i + 1;
  }
  return trials.size();
}

void ask(traversal& under_test, const trial& t, visited& out) {
  out.clear();
  if (!under_test.takes(t.cells(), t.end.has_value()))
    return out.decline();
  guard(out, [&] { under_test.visit(t, out); });
  if (t.map)
    out.keep(t.all());
}

std::unique_ptr<traversal> traversal_entry::guarded() const {
  return std::make_unique<made_again>(make);
}

} // namespace graze::fuzz
