/* The slab test of Williams, Barrus, Morley and Shirley (2005) on every voxel of the block, in
   float, for graze-fuzz to look at:

   cc -O2 -o slabs slabs.c && graze-fuzz run --level 10 --command ./slabs */
#include <stdio.h>

/* The ray o + t d, t >= 0, meets the box; one_over[a] = 1 / d[a]. */
static int meets(const float o[3], const float one_over[3], const float box[2][3]) {
  float enter = 0, leave = 1e38f;
  for (int a = 0; a < 3; ++a) {
    const int backwards = one_over[a] < 0;
    const float near = (box[backwards][a] - o[a]) * one_over[a];
    const float far = (box[!backwards][a] - o[a]) * one_over[a];
    if (near > enter)
      enter = near;
    if (far < leave)
      leave = far;
  }
  return enter <= leave;
}

int main(void) {
  unsigned long long id, base[3], extent[3];
  int level, first = 1;
  double o[3], d[3], lo[3], size; /* scanf reads hex floats exactly */
  double echo[16] = {0};
  printf("promise crossed numbers hex float true echo true\n");
  fflush(stdout);
  while (scanf("%llu %d %llu %llu %llu %llu %llu %llu", &id, &level, &base[0], &base[1], &base[2],
               &extent[0], &extent[1], &extent[2]) == 8 &&
         scanf("%lf %lf %lf %lf %lf %lf %lf %lf %lf %lf", &o[0], &o[1], &o[2], &d[0], &d[1], &d[2],
               &lo[0], &lo[1], &lo[2], &size) == 10) {
    if (first && scanf(" echo") != EOF) /* 16 doubles to be given back, once */
      for (int i = 0; i < 16; ++i)
        if (scanf("%lf", &echo[i]) != 1)
          return 2;
    const double voxel = size / (double)(1ull << level);
    float origin[3], one_over[3], box[2][3];
    for (int a = 0; a < 3; ++a) {
      origin[a] = (float)o[a]; /* exact: "float true" has them rounded before */
      one_over[a] = 1 / (float)d[a];
    }
    for (unsigned long long n = 0; n < extent[0] * extent[1] * extent[2]; ++n) {
      const unsigned long long at[3] = {base[0] + n % extent[0],
                                        base[1] + n / extent[0] % extent[1],
                                        base[2] + n / extent[0] / extent[1]};
      for (unsigned i = 0; i < 6; ++i)
        box[i / 3][i % 3] = (float)(lo[i % 3] + (double)(at[i % 3] + i / 3) * voxel);
      if (meets(origin, one_over, box))
        printf("%llu %llu %llu ", at[0], at[1], at[2]);
    }
    for (int i = 0; first && i < 16; ++i)
      printf(i == 0 ? "echo %a " : "%a ", echo[i]);
    first = 0;
    printf("\n"); /* a line without voxels: none is visited */
    fflush(stdout);
  }
  return 0;
}
