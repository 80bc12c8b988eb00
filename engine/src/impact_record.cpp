#include "impact_record.hpp"

#include <algorithm>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace carom {
namespace {

/// Of what a pair does more than once at a time, which comes first does not depend on the workers.
auto place(const Impact& impact) {
  return std::tuple(impact.time, impact.a, impact.b, impact.wall, impact.kind, impact.impulse,
                    impact.tangential, impact.energy_lost);
}

}  // namespace

bool is_before(const Impact& one, const Impact& other) {
  return place(one) < place(other);
}

void ImpactRecord::add(std::vector<Impact> impacts, const std::vector<std::size_t>& ids) {
  const std::uint64_t joint = joints_;
  for (Impact& impact : impacts) {
    if (impact.a != Impact::kNoBall) impact.a = ids[impact.a];
    if (impact.b != Impact::kNoBall) impact.b = ids[impact.b];
    latest_ = std::max(latest_, impact.time);
    if (impact.event == 0) continue;
    impact.event += joint;
    joints_ = std::max(joints_, impact.event);
  }
  impacts_.insert(impacts_.end(), impacts.begin(), impacts.end());
}

void ImpactRecord::add(Impact command) {
  latest_ = std::max(latest_, command.time);
  command.time = latest_;
  impacts_.push_back(command);
}

std::vector<Impact> ImpactRecord::take() {
  std::stable_sort(impacts_.begin(), impacts_.end(), is_before);
  std::unordered_map<std::uint64_t, std::uint64_t> number_of_joint;
  for (Impact& impact : impacts_) {
    if (impact.event == 0) {
      impact.event = next_event_++;
    } else {
      const auto [joint, is_new] = number_of_joint.try_emplace(impact.event, next_event_);
      if (is_new) ++next_event_;
      impact.event = joint->second;
    }
  }
  joints_ = 0;
  return std::exchange(impacts_, {});
}

}  // namespace carom
