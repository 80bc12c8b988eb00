#pragma once

#include <span>
#include <vector>

#include "contact/pair_list.hpp"

namespace carom::contact {

/// Passes on how far balls may be pushed: a ball pushed farther than its gap to another one pushes
/// that one by the rest.
///
/// `pushes`, by ball: how far each is pushed, itself or by others; raised until nothing changes.
/// `gaps`, by pair: an overlap counts as none.
/// Holds: no order of balls or pairs changes a bit.
void pass_on_pushes(std::span<const Pair> pairs, std::span<const double> gaps,
                    std::vector<double>& pushes);

}  // namespace carom::contact
