#include "walk_by.hpp"

constinit const graze::test::path_under_test graze::test::avx512_walks =
    graze::test::walks_by<graze::batch::avx512>();
