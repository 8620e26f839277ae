#include "walk_by.hpp"

constinit const graze::test::path_under_test graze::test::avx2_walks =
    graze::test::walks_by<graze::batch::avx2>();
