/// NanoVDB: the walks of its HDDA through a grid, in float and in cells of edge 1
/// (bench/peers/nanovdb.cpp).
///
///   graze-adapter-nanovdb first-active|hdda
///
/// first-active: firstActive() again and again, each time without the voxels that it has found.
/// hdda: the loop of ZeroCrossing() in HDDA.h, which keeps each active voxel that it comes to.
#include "peer.hpp"
#include <string_view>

int main(int argc, char** argv) {
  const std::string_view variant = argc > 1 ? argv[1] : "";
  if (variant == "first-active")
    return adapter::serve("crossed", adapter::ask_peer<graze::bench::nanovdb_first_active>);
  if (variant == "hdda")
    return adapter::serve("crossed", adapter::ask_peer<graze::bench::nanovdb_hdda>);
  std::fprintf(stderr, "usage: graze-adapter-nanovdb first-active|hdda\n");
  return 2;
}
