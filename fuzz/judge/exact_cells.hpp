#pragma once
/// A trial's line and cells as rational numbers: for what doubles cannot say, and for a second opinion.
#include <graze/oracle/rational.hpp>
#include <trial/trial.hpp>

namespace graze::fuzz {

oracle::rational::line rational_line(const trial& t);

/// The closed box of a cell. Planes are those of oracle::rational, which come about by other arithmetic
/// than those that the campaign judges by.
oracle::rational::box rational_cell(const trial& t, octant_number v);

/// The closed box of all of a block.
oracle::rational::box rational_block(const trial& t);

/// Bit a is set where the cell ends at the far face of axis a of the root or grid; none of a list's boxes.
unsigned far_faces_of(const trial& t, octant_number v);

} // namespace graze::fuzz
