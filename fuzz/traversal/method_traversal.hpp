#pragma once
/// Drives any graze::octree::Method through a trial's block.
#include <traversal/block_tree.hpp>
#include <traversal/traversal.hpp>

namespace graze::fuzz {

template <octree::Method M> class method_traversal final : public traversal {
public:
  method_traversal(std::string_view name, promise p) : name_(name), promise_(p) {}

  [[nodiscard]] std::string_view name() const override { return name_; }
  [[nodiscard]] promise promises() const override { return promise_; }

  void visit(const trial& t, visited& out) override {
    const auto ray = octree::ray::make(t.origin, t.direction);
    [[maybe_unused]] const typename M::scope in_mode;
    const M method(*ray);
    if (t.level == 0) { // the root itself is the octant in question
      typename M::state state{};
      if (method.enter(t.root, state))
        out.push(0);
      return;
    }
    const block_tree tree(t);
    octree::descend(method, t.root, t.level, tree,
                    [&](const cube&, const block_tree::node& n, const typename M::state&) {
                      out.push(tree.octant_of(n));
                      return false;
                    });
  }

private:
  std::string_view name_;
  promise promise_;
};

} // namespace graze::fuzz
