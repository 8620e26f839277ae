/* Linked with gcc -Ofast, this sets FTZ and DAZ in whatever process loads it. */
double graze_fast_library(double x) { return x + 1; }
