#include "solvers/event/impact_lines.hpp"

#include <algorithm>
#include <utility>

namespace carom::event {

Impact single_line(Impact contact, const SingleImpact& impact) {
  // Both impulses are the same seen from either of the two; here the normal leads away from the
  // one whose velocity is known.
  const Vec2 n = impact.from_a ? contact.normal : -contact.normal;
  const Vec2 t{-n.y(), n.x()};
  contact.impulse = impact.change.dot(n) / impact.inverse_mass;
  contact.energy_lost = impact.lost;
  if (impact.friction) contact.tangential = impact.change.dot(t) / impact.inverse_mass;
  return contact;
}

std::vector<Impact> joint_lines(std::span<const Impact> contacts, const JointCarried& carried,
                                std::uint64_t event) {
  std::vector<Impact> lines;
  // Where no restitution takes energy, what is held in a gap of zero is all that is lost.
  double held = carried.held;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const auto add = [&]() -> Impact& {
      Impact& line = lines.emplace_back(contacts[k]);
      line.kind = ImpactKind::joint;
      line.event = event;
      return line;
    };
    carom::FrictionChange by_friction =
        carried.by_friction.empty() ? carom::FrictionChange{} : carried.by_friction[k];
    for (const JointCarried::Push& push : carried.pushes) {
      if (push.contact != k) continue;
      Impact& line = add();
      line.impulse = push.impulse;
      line.tangential = by_friction.impulse;
      line.energy_lost = by_friction.lost + (carried.elastic ? std::exchange(held, 0) : push.lost);
      by_friction = {};
    }
    if (by_friction.impulse == 0) continue;
    Impact& line = add();
    line.kind = ImpactKind::rest;
    line.tangential = by_friction.impulse;
    line.energy_lost = by_friction.lost;
  }
  return lines;
}

std::vector<Impact> island_lines(std::span<const Impact> contacts, const IslandCarried& carried,
                                 std::uint64_t event) {
  std::vector<Impact> lines;
  const auto counted = std::count(carried.counted.begin(), carried.counted.end(), 1);
  double lost = carried.lost;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const bool last = k + 1 == contacts.size();
    if (carried.counted[k] == 0 && !(carried.impulses[k] > 0) && !(last && lost != 0)) continue;
    Impact& line = lines.emplace_back(contacts[k]);
    line.impulse = carried.impulses[k];
    line.energy_lost = std::exchange(lost, 0);
    if (carried.counted[k] == 0) {
      line.kind = ImpactKind::rest;
    } else if (counted > 1) {
      line.kind = ImpactKind::joint;
      line.event = event;
    }
  }
  return lines;
}

}  // namespace carom::event
