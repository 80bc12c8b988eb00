#pragma once

#include "contact/cone_response.hpp"

namespace carom::event {

/// Of more edges impulses are not guessed.
inline constexpr std::size_t kMostEdgesGuessed = 512;

/// Finds what ConeDescent looks for where its way is long, as between heavy balls and light ones,
/// by full factors.
///
/// Gives whether it was found; if not, `impulses` are as before, which it starts from where no
/// interior point is found.  Edges that close are let in all at once, and the way to where those
/// that are in part no more ends where the first would pull, which then leaves.  In the end that is
/// refined in double-double, and 46 bits of the largest impulse are kept.
/// Holds: so the bits do not depend on the order of contacts or bodies, though rounding on the way
/// does.  Contacts give way to nothing in the end, as in ConeDescent.
/// Source: Lawson and Hanson, Solving Least Squares Problems (1974), ch. 23, with several at once;
/// Higham, Accuracy and Stability of Numerical Algorithms (2002), ch. 12.
bool guess_cone_impulses(const ConeResponse& response, const ConeResponse::Column& parting,
                         double goal, ConeResponse::Column& impulses);

}  // namespace carom::event
