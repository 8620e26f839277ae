/// The picture of a reproducer, in two panels: the octants to scale, and the edge that the ray
/// passes, magnified until their distance is seen. Everything is placed by rationals and rounded to
/// a hundredth of a pixel at the end.
#include <cmath>
#include <fmt/format.h>
#include <graze/support/text.hpp>
#include <report/reproducer/passage.hpp>
#include <trial/number.hpp>

namespace graze::fuzz {

namespace {

constexpr double width = 600;
constexpr double left = 170, top = 64, side = 400; ///< the first panel's square
constexpr double magnified_distance = 70;          ///< px, in the second panel
constexpr double small_distance = 1.0 / 40; ///< of an octant: below, the second panel is drawn

std::string label(double x, double y, std::string_view text, std::string_view more = "") {
  return fmt::format("<text x=\"{:.2f}\" y=\"{:.2f}\"{}>{}</text>\n", x, y, more,
                     support::markup(text));
}

std::string line(double x0, double y0, double x1, double y1, std::string_view style) {
  return fmt::format("<line x1=\"{:.2f}\" y1=\"{:.2f}\" x2=\"{:.2f}\" y2=\"{:.2f}\" {}/>\n", x0, y0,
                     x1, y1, style);
}

constexpr std::string_view ray_style = "class=\"ray\" stroke=\"#0550ae\" stroke-width=\"2\"";
constexpr std::string_view plane_style = "stroke=\"#555\" stroke-width=\"1\"";
constexpr std::string_view right_aligned = " text-anchor=\"end\"";
constexpr std::string_view centred = " text-anchor=\"middle\"";

/// A filled arrowhead whose tip is (x, y), pointing along (dx, dy), a unit vector.
std::string arrow(double x, double y, double dx, double dy) {
  const double base_x = x - 13 * dx, base_y = y - 13 * dy;
  return fmt::format("<polygon class=\"ray\" points=\"{:.2f},{:.2f} {:.2f},{:.2f} {:.2f},{:.2f}\" "
                     "fill=\"#0550ae\"/>\n",
                     x, y, base_x - 5 * dy, base_y + 5 * dx, base_x + 5 * dy, base_y - 5 * dx);
}

class drawing {
public:
  explicit drawing(const reproduction& r)
      : r_(r), t_(r.answered), box_(r.octant()), p_(passage_of(t_, box_)),
        h_(std::min(p_.along, p_.across)), v_(std::max(p_.along, p_.across)), third_(3 - h_ - v_) {}

  std::string svg() {
    title();
    octants();
    ray();
    ticks();
    double y = legend(top + side + 62);
    if (const mpq_class part = abs(p_.distance) / mpq_class(box_.size); part < small_distance)
      y = edge(y + 14);
    return fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                       "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" "
                       "height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} {1:.0f}\" "
                       "font-family=\"DejaVu Sans Mono, monospace\" font-size=\"11\">\n"
                       "<defs><pattern id=\"hatch\" width=\"8\" height=\"8\" "
                       "patternUnits=\"userSpaceOnUse\" patternTransform=\"rotate(45)\">"
                       "<line x1=\"0\" y1=\"0\" x2=\"0\" y2=\"8\" stroke=\"#2a7d2a\" "
                       "stroke-width=\"2\"/></pattern></defs>\n"
                       "<rect width=\"{0:.0f}\" height=\"{1:.0f}\" fill=\"white\"/>\n",
                       width, y + 10) +
           body_ + "</svg>\n";
  }

private:
  /// Sizes of octants from the view's lower corner: the block with a margin.
  [[nodiscard]] double cells() const { return std::max(t_.extent[h_], t_.extent[v_]) + 2 * margin; }
  static constexpr double margin = 0.6;

  /// A coordinate on an axis, in octants from the view's lower corner.
  [[nodiscard]] mpq_class in_cells(unsigned axis, const mpq_class& x) const {
    return (x - mpq_class(t_.plane(static_cast<int>(axis), 0))) / mpq_class(t_.size()) +
           mpq_class(margin);
  }
  [[nodiscard]] double px(double in_cells_h) const { return left + in_cells_h / cells() * side; }
  [[nodiscard]] double py(double in_cells_v) const {
    return top + side - in_cells_v / cells() * side;
  }
  [[nodiscard]] double place(unsigned k) const { return margin + k; }
  [[nodiscard]] unsigned index_of(octant_number v, unsigned axis) const {
    return v >> (2 * axis) & 3u;
  }

  void title() {
    body_ += label(12, 22, fmt::format("{} by {}", name_of(r_.kind), r_.traversal.substr(0, 40)),
                   " font-size=\"15\" font-weight=\"bold\"");
    body_ +=
        label(12, 42,
              fmt::format("axes {} and {}{}; level {}, octant size {}", "xyz"[h_], "xyz"[v_],
                          t_.extent[third_] > 1 ? fmt::format(" (layer {} = {})", "xyz"[third_],
                                                              spelled_short(box_.lo[third_]))
                                                : std::string(),
                          t_.level, spelled_short(box_.size)));
  }

  void cell(unsigned i, unsigned j, std::string_view style) {
    const double edge_length = side / cells();
    body_ +=
        fmt::format("<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" {}/>\n",
                    px(place(i)), py(place(j + 1)), edge_length, edge_length, style);
  }

  void octants() {
    body_ += fmt::format("<clipPath id=\"view\"><rect x=\"{0}\" y=\"{1}\" width=\"{2}\" "
                         "height=\"{2}\"/></clipPath>\n<g clip-path=\"url(#view)\">\n",
                         left, top, side);
    for (unsigned i = 0; i < t_.extent[h_]; ++i)
      for (unsigned j = 0; j < t_.extent[v_]; ++j) {
        std::array<unsigned, 3> at{};
        at[h_] = i;
        at[v_] = j;
        at[third_] = index_of(r_.subject, third_);
        const octant_number v = octant_at(at[0], at[1], at[2]);
        const bool visited = (r_.answer.set() >> v & 1) != 0;
        cell(i, j, "class=\"octant\" fill=\"#eee\"");
        if (v == r_.subject)
          cell(i, j, "id=\"missed\" fill=\"#f4a29b\" stroke=\"#c00\" stroke-width=\"3\"");
        if (visited)
          cell(i, j, "class=\"visited\" fill=\"url(#hatch)\"");
      }
    // planes of the grid as far as the root goes, the root's own faces thick
    for (const unsigned axis : {h_, v_}) {
      const unsigned other = axis == h_ ? v_ : h_;
      const double from = (t_.at_near_face() >> other & 1) != 0 ? margin : 0;
      const double to = (t_.at_far_face() >> other & 1) != 0 ? margin + t_.extent[other] : cells();
      for (unsigned k = 0; k <= t_.extent[axis]; ++k) {
        const bool face = (k == 0 && (t_.at_near_face() >> axis & 1) != 0) ||
                          (k == t_.extent[axis] && (t_.at_far_face() >> axis & 1) != 0);
        const std::string_view style =
            face ? "class=\"root\" stroke=\"#222\" stroke-width=\"2.5\"" : plane_style;
        body_ += axis == h_ ? line(px(place(k)), py(from), px(place(k)), py(to), style)
                            : line(px(from), py(place(k)), px(to), py(place(k)), style);
      }
    }
    body_ += "</g>\n";
    body_ += fmt::format("<rect x=\"{0}\" y=\"{1}\" width=\"{2}\" height=\"{2}\" fill=\"none\" "
                         "stroke=\"#bbb\"/>\n",
                         left, top, side);
  }

  /// The ray as far as it is in the view, clipped in rationals.
  void ray() {
    mpq_class from = 0;
    std::optional<mpq_class> to;
    const mpq_class far_side(cells());
    for (const unsigned axis : {h_, v_}) {
      const mpq_class o = in_cells(axis, mpq_class(t_.origin[axis]));
      const mpq_class d = mpq_class(t_.direction[axis]) / mpq_class(t_.size());
      if (d == 0) {
        if (o < 0 || o > far_side)
          return;
        continue;
      }
      mpq_class enter = -o / d;
      mpq_class leave = (far_side - o) / d;
      if (leave < enter)
        std::swap(enter, leave);
      if (enter > from)
        from = enter;
      if (!to || leave < *to)
        to = leave;
    }
    if (!to || *to < from)
      return;
    const auto at = [&](unsigned axis, const mpq_class& t) {
      const mpq_class x =
          in_cells(axis, mpq_class(t_.origin[axis]) + t * mpq_class(t_.direction[axis]));
      return x.get_d();
    };
    const double x0 = px(at(h_, from)), y0 = py(at(v_, from));
    const double x1 = px(at(h_, *to)), y1 = py(at(v_, *to));
    body_ += line(x0, y0, x1, y1, ray_style);
    if (const double length = std::hypot(x1 - x0, y1 - y0); length > 1)
      body_ += arrow(x1, y1, (x1 - x0) / length, (y1 - y0) / length);
    if (from == 0)
      body_ +=
          fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"5\" fill=\"#0550ae\"/>\n", x0, y0);
  }

  /// Exact coordinates of the octant's planes, and of the block's others where they are short.
  void ticks() {
    for (const unsigned axis : {h_, v_}) {
      const unsigned subject = index_of(r_.subject, axis);
      double row = 0;
      for (unsigned k = 0; k <= t_.extent[axis]; ++k) {
        const std::string text = spelled_short(t_.plane(static_cast<int>(axis), k));
        const bool of_subject = k == subject || k == subject + 1;
        if (!of_subject && text.size() > 6)
          continue;
        if (axis == h_) {
          const bool lower = text.size() > 6 && k == subject + 1; // long ones in two rows
          row = top + side + (lower ? 28 : 14);
          body_ += label(px(place(k)), row, text, centred);
        } else {
          body_ += label(left - 6, py(place(k)) + 4, text, right_aligned);
        }
      }
    }
    body_ +=
        label(left + side, top + side + 44, fmt::format("{} \u2192", "xyz"[h_]), right_aligned);
    body_ += label(left - 6, top - 6, fmt::format("{} \u2191", "xyz"[v_]), right_aligned);
  }

  double legend(double y) {
    const auto row = [&](const std::string& text) {
      body_ += label(12, y, text);
      y += 17;
    };
    const auto triple = [](const vec3& v) {
      return fmt::format("({}, {}, {})", spelled_short(v[0]), spelled_short(v[1]),
                         spelled_short(v[2]));
    };
    row("origin    " + triple(t_.origin));
    row("direction " + triple(t_.direction));
    row("octant    " + triple(box_.lo));
    row(fmt::format("red: {}; {}", fault_of(r_.kind), claim_of(r_.kind, r_.promises)));
    if (p_.range)
      row(fmt::format("the ray is in it for {:.6g} of its size; hatched: visited", p_.chord(t_)));
    return y;
  }

  /// The second panel: the edge and the ray's line beside it.
  double edge(double y) {
    const double x0 = 12, panel_width = width - 24, height = 250;
    const double cx = x0 + panel_width / 2, cy = y + 22 + height / 2;
    body_ +=
        label(x0, y + 10,
              fmt::format("the edge {} = {}, {} = {}, magnified", "xyz"[h_],
                          spelled_short(p_.corner[h_]), "xyz"[v_], spelled_short(p_.corner[v_])),
              " font-weight=\"bold\"");
    body_ += fmt::format("<clipPath id=\"edge\"><rect x=\"{0}\" y=\"{1}\" width=\"{2}\" "
                         "height=\"{3}\"/></clipPath>\n<g clip-path=\"url(#edge)\">\n",
                         x0, y + 22, panel_width, height);
    // the octant's quadrant
    const bool right = p_.corner[h_] == box_.lo[h_];
    const bool above = p_.corner[v_] == box_.lo[v_];
    body_ += fmt::format("<rect class=\"missed\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" "
                         "fill=\"#f4a29b\"/>\n",
                         right ? cx : x0, above ? y + 22 : cy, panel_width / 2, height / 2);
    body_ += line(x0, cy, x0 + panel_width, cy, plane_style);
    body_ += line(cx, y + 22, cx, y + 22 + height, plane_style);
    // the ray's line: through the point at the distance from the edge on `across`
    const double sign = sgn(p_.distance);
    std::array<double, 3> offset{}; // px, upwards positive
    offset[p_.across] = sign * magnified_distance;
    const mpq_class slope = mpq_class(t_.direction[p_.across]) / mpq_class(t_.direction[p_.along]);
    std::array<double, 3> unit{};
    unit[p_.along] = t_.direction[p_.along] < 0 ? -1 : 1;
    unit[p_.across] = slope.get_d() * unit[p_.along];
    const double length = std::hypot(unit[h_], unit[v_]);
    const double dx = unit[h_] / length, dy = -unit[v_] / length;
    const double rx = cx + offset[h_], ry = cy - offset[v_];
    // where the ray starts, if that is within the panel at this magnification
    double back = 1000;
    bool starts = false;
    const mpq_class before = abs(mpq_class(p_.corner[p_.along]) - mpq_class(t_.origin[p_.along]));
    if (p_.distance == 0 ? before == 0 : before < 10 * abs(p_.distance)) {
      const mpq_class ratio =
          p_.distance == 0 ? mpq_class(0) : mpq_class(before / abs(p_.distance));
      const double ahead = ratio.get_d() * magnified_distance / std::fabs(unit[p_.along]) * length;
      // the edge may lie behind the origin
      const bool behind =
          sgn(mpq_class(p_.corner[p_.along]) - mpq_class(t_.origin[p_.along])) * unit[p_.along] < 0;
      back = behind ? -ahead : ahead;
      starts = true;
    }
    body_ += line(rx - back * dx, ry - back * dy, rx + 1000 * dx, ry + 1000 * dy, ray_style);
    body_ += arrow(rx + 100 * dx, ry + 100 * dy, dx, dy);
    if (starts)
      body_ += fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"5\" fill=\"#0550ae\"/>\n",
                           rx - back * dx, ry - back * dy);
    body_ += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"4\" fill=\"#222\"/>\n", cx, cy);
    if (sign != 0)
      body_ +=
          line(cx, cy, rx, ry, "stroke=\"#222\" stroke-width=\"1.5\" stroke-dasharray=\"4 3\"");
    body_ += "</g>\n";
    body_ += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" "
                         "stroke=\"#bbb\"/>\n",
                         x0, y + 22, panel_width, height);
    y += 22 + height + 17;
    if (sign == 0) {
      body_ += label(x0, y, "the ray's line meets the edge exactly: distance 0");
      return y + 17;
    }
    body_ += label(x0, y,
                   fmt::format("dashed, on {}: {} = {:.6g} ulps of {}", "xyz"[p_.across],
                               spelled(abs(p_.distance)), p_.distance_in_ulps(), hex(p_.ulp)));
    return y + 17;
  }

  const reproduction& r_;
  const trial& t_;
  cube box_;
  passage p_;
  unsigned h_, v_, third_; ///< horizontal, vertical, and the axis looked along
  std::string body_;
};

} // namespace

std::string reproducer_picture(const reproduction& r) { return drawing(r).svg(); }

} // namespace graze::fuzz
