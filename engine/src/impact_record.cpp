#include "impact_record.hpp"

#include <algorithm>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace carom {
namespace {

auto place(const Impact& impact) {
  return std::tuple(impact.time, impact.a, impact.b, impact.wall);
}

}  // namespace

bool is_before(const Impact& one, const Impact& other) {
  return place(one) < place(other);
}

void ImpactRecord::add(std::vector<Impact> impacts, const std::vector<std::size_t>& ids) {
  for (Impact& impact : impacts) {
    if (impact.a != Impact::kNoBall) impact.a = ids[impact.a];
    if (impact.b != Impact::kNoBall) impact.b = ids[impact.b];
  }
  std::stable_sort(impacts.begin(), impacts.end(), is_before);
  std::unordered_map<std::uint64_t, std::uint64_t> number_of_joint;
  for (Impact& impact : impacts) {
    if (impact.event == 0) {
      impact.event = next_event_++;
    } else {
      const auto [joint, is_new] = number_of_joint.try_emplace(impact.event, next_event_);
      if (is_new) ++next_event_;
      impact.event = joint->second;
    }
  }
  if (!impacts.empty()) latest_ = std::max(latest_, impacts.back().time);
  impacts_.insert(impacts_.end(), impacts.begin(), impacts.end());
}

void ImpactRecord::add(Impact command) {
  latest_ = std::max(latest_, command.time);
  command.time = latest_;
  command.event = next_event_++;
  impacts_.push_back(command);
}

std::vector<Impact> ImpactRecord::take() {
  return std::exchange(impacts_, {});
}

}  // namespace carom
