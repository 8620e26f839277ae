/// PCL: OctreePointCloudSearch::getIntersectedVoxelIndices, in float (bench/peers/pcl.cpp).
///
///   graze-adapter-pcl
#include "peer.hpp"

int main() { return adapter::serve("crossed", adapter::ask_peer<graze::bench::pcl>); }
