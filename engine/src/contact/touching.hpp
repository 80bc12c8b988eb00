#pragma once

#include <array>
#include <vector>

#include "contact/pair_list.hpp"

namespace carom {

/// Appends the pairs number [begin, end) of a list that overlap, in the list's order: bounding
/// boxes first, then the disks themselves.  Gives the deepest overlap among them as a fraction of
/// the smaller radius.  With a `stretch` above 1 pairs that would overlap were their balls larger
/// by that factor are appended too.
double find_touching(const PairList& pairs, std::size_t begin, std::size_t end, const Balls& balls,
                     const std::array<double, 2>& periods, double stretch,
                     std::vector<Pair>& touching);

}  // namespace carom
