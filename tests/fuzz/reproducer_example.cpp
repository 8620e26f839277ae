// crossed-miss by published: the ray crosses its interior (octant missed).
// Root (0x0p+0, 0x0p+0, 0x0p+0) size 0x1p+0, level 50.
namespace graze_published_crossed_miss_0a782b05 {
constexpr double origin[3] = {0x1.89629603723cep-1, 0x1.abdcf56180d59p-1, 0x1.09418883283dp-2};
constexpr double direction[3] = {-0x1.2e3acaacf4b96p-1, -0x1.dc33242b6d7f4p-1, 0x1.0294e0746797cp-1};
constexpr double lo[3] = {0x1.1fd52bb47c85p-2, 0x1.165b57bbd0b4p-4, 0x1.5a1181eb0c588p-1};
constexpr double hi[3] = {0x1.1fd52bb47c86p-2, 0x1.165b57bbd0b8p-4, 0x1.5a1181eb0c59p-1};
// Times 2^53 and 2^52 these are integers: whether the ray meets the open interior is decided
// here without rounding. On any two axes it enters on one before it leaves on the other.
__extension__ typedef __int128 integer;
constexpr integer place(double x) { return static_cast<integer>(x * 0x1p+53); }
constexpr integer speed(int axis) { return static_cast<integer>(direction[axis] * 0x1p+52); }
constexpr integer way_to(int axis, bool far) {
  return direction[axis] < 0 ? place(origin[axis]) - place((far ? lo : hi)[axis])
                             : place((far ? hi : lo)[axis]) - place(origin[axis]);
}
constexpr bool crosses_interior() {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const integer along_i = speed(i) < 0 ? -speed(i) : speed(i);
      const integer along_j = speed(j) < 0 ? -speed(j) : speed(j);
      const bool before = way_to(i, false) * along_j < way_to(j, true) * along_i;
      if ((along_i != 0 || along_j != 0) && !before)
        return false;
      if (!(way_to(i, true) > 0))
        return false;
    }
  return true;
}
static_assert(crosses_interior(), "decided by integers");
}
