#include "solvers/overlap/island_rounds.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace carom::overlap {

void IslandRounds::find_asleep() {
  if (std::exchange(knows_asleep_, true)) return;
  if (!rules_.sleeps) return contacts_.wake_all(balls_);
  std::vector<Pair> near;
  if (rules_.collides) {
    if (pairs_.uses_list()) pairs_.build(rules_.step);
    near = pairs_.all_touching();
  }
  contacts_.find_asleep(balls_, near);
}

void IslandRounds::form(std::span<const Pair> touching, std::span<const std::uint32_t> out) {
  rounds_ = 0;
  contacts_.form(balls_, touching, out);
}

// Where a solution brings balls together that it has not looked at, all are solved again with
// them: first those alone, then, rather than follow a push from ball to ball, all that are near.
bool IslandRounds::join(std::vector<Pair>& touching) {
  constexpr int kRounds = 6;
  constexpr int kRoundsAlone = 2;
  if (contacts_.islands() == 0 || rounds_ >= kRounds) return false;
  std::vector<Pair> crossing;
  if (rules_.collides) {
    contacts_.find_crossing(balls_, touching, crossing);
    find_far_overlaps(touching, crossing);
  }
  if (crossing.empty() && !contacts_.any_driven()) return false;
  contacts_.join(balls_, touching, crossing, rounds_ >= kRoundsAlone);
  ++rounds_;
  return true;
}

// Balls that were pushed far may have come to others that were not near.
void IslandRounds::find_far_overlaps(std::vector<Pair>& touching, std::vector<Pair>& fresh) {
  const double slack = 2 * contact::LastingContacts::kNear * rules_.smallest_radius;
  if (!(2 * contacts_.farthest_push() >= slack)) return;
  const std::vector<Pair> found = pairs_.overlapping_after_pushes(rules_.step);
  const std::size_t crossing = fresh.size();
  std::set_difference(found.begin(), found.end(), touching.begin(), touching.end(),
                      std::back_inserter(fresh));
  touching.insert(touching.end(), fresh.begin() + static_cast<std::ptrdiff_t>(crossing),
                  fresh.end());
  std::sort(touching.begin(), touching.end());
}

}  // namespace carom::overlap
