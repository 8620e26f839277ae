#pragma once
/// One small change of a trial: the moves of the hill climb and of the libFuzzer targets.
#include <generate/random.hpp>
#include <trial/trial.hpp>

namespace graze::fuzz {

/// t after one of: a step of some ulps of one number of the ray; the origin put on a plane of the
/// grid; the ray aimed at a vertex or an edge of the block, direction rounded or exact; another
/// level; a sign; an exponent; a component made zero; fewer significant bits; the block moved or
/// another size; two axes exchanged; the whole scene scaled. Passes judgeable() if t does; t itself
/// where no move succeeded.
trial mutated(random_stream& random, const trial& t);

} // namespace graze::fuzz
