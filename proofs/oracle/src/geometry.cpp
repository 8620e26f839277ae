#include <graze/oracle/geometry.hpp>
