// The walks of sound_eight, compiled for each path.
#include "walk_by.hpp"

constinit const graze::test::path_under_test
    graze::test::GRAZE_ON_PATH(walks) = graze::test::walks_by<graze::batch::this_path>();
