// e^1 + sin 1 through a shared object; 0 if its bounds are those of a program that holds the
// archive.
extern "C" void shared_exp(double x, double* lower, double* upper);

int main() {
  double lower = 0, upper = 0;
  shared_exp(1, &lower, &upper);
  // e + sin 1 = 3.559752813266941739...
  return lower < 3.55975281326694174 && 3.55975281326694173 < upper && upper - lower < 0x1p-49 ? 0
                                                                                               : 1;
}
