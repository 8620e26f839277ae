#include "walk_by.hpp"

constinit const graze::test::path_under_test graze::test::baseline_walks =
    graze::test::walks_by<graze::batch::baseline>();
