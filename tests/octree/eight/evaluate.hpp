#pragma once
/// The scenes' surfaces over boxes, eight at a time, by a path. Included by a file for each path,
/// compiled for its instructions.
#include <cstddef>

namespace graze::test {

struct eight_boxes {
  const double *lo[3], *hi[3];
};
enum { spheres_scene, quartdef_scene, tanglecube_scene, holesrot_scene, scene_count };
struct eight_values {
  double lo[scene_count][8], hi[scene_count][8];
  unsigned holds_zero[scene_count];
};

void evaluate_baseline(const eight_boxes& x, eight_values& r);
void evaluate_avx2(const eight_boxes& x, eight_values& r);
void evaluate_avx512(const eight_boxes& x, eight_values& r);

} // namespace graze::test
