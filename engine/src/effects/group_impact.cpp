#include "effects/group_impact.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "contact/joint_impact.hpp"
#include "effects/friction.hpp"

namespace carom::effects {
namespace {

constexpr double kUnequal = 16;         // masses: see contact/contacts_last.cpp
constexpr std::size_t kMostJoint = 64;  // contacts: a joint impact of more costs too much

struct WallContact {
  std::size_t member;
  std::size_t axis;
  double outwards;
};

bool at_wall(const Member& member, const Domain& domain, std::size_t axis, double outwards) {
  if (member.inverse_mass == 0 || !domain.solid(axis)) return false;
  const double x = member.position[axis];
  return outwards < 0 ? x <= domain.lowest(axis, member.radius)
                      : x >= domain.highest(axis, member.radius);
}

}  // namespace

bool ends_slowly(const ContactGroup& group) {
  if (group.contacts.size() > kMostJoint || group.pulled) return false;
  double least = 0;
  double most = 0;
  for (const Member& member : group.members) {
    if (member.inverse_mass == 0) continue;
    least = least == 0 ? member.mass : std::min(least, member.mass);
    most = std::max(most, member.mass);
  }
  return most > kUnequal * least;
}

void end_impacts(ContactGroup& group, const Domain& domain, const CollisionRule& rule,
                 ImpactCount& count) {
  using Velocity = event::Vec<double>;
  std::vector<event::Body<double>> bodies;
  std::vector<event::Contact<double>> contacts;
  std::vector<std::size_t> pairs;
  std::vector<WallContact> walls;
  for (const Member& member : group.members) {
    bodies.push_back({Velocity{member.velocity.x(), member.velocity.y()}, member.inverse_mass});
  }
  for (std::size_t k = 0; k < group.contacts.size(); ++k) {
    const Contact& contact = group.contacts[k];
    if (!contact.touching) continue;
    pairs.push_back(k);
    contacts.push_back({static_cast<int>(contact.a), static_cast<int>(contact.b),
                        Velocity{contact.line.r.x(), contact.line.r.y()}, rule.restitution});
  }
  for (std::size_t m = 0; m < group.members.size(); ++m) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      for (const double outwards : {-1.0, 1.0}) {
        if (!at_wall(group.members[m], domain, axis, outwards)) continue;
        walls.push_back({m, axis, outwards});
        contacts.push_back({static_cast<int>(m), event::kWall,
                            axis == 0 ? Velocity{outwards, 0} : Velocity{0, outwards},
                            rule.wall_restitution});
      }
    }
  }
  event::JointImpact<double> impact(bodies, contacts);
  const event::JointReport report = impact.resolve();
  const std::vector<double>& gains = impact.gains();
  count.ball_ball += static_cast<std::uint64_t>(report.impacts);
  count.ball_wall += static_cast<std::uint64_t>(report.walls);
  count.lost += report.lost;
  double all = 0;
  for (std::size_t m = 0; m < bodies.size(); ++m) {
    group.members[m].velocity = {bodies[m].velocity.x, bodies[m].velocity.y};
  }
  for (const double gain : gains) all += gain;
  const auto part_of_loss = [&](std::size_t k) {
    return all > 0 ? report.lost * gains[k] / all : 0;
  };
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    if (!(gains[k] > 0)) continue;
    const Contact& contact = group.contacts[pairs[k]];
    const double normal = gains[k] / contact.inverse_masses;
    FrictionChange change;
    if (rule.friction > 0) {
      change = apply_friction(group.members[contact.a], group.members[contact.b], contact.line,
                              normal, rule.friction);
    }
    count.lost += change.lost;
    if (!count.log.wanted) continue;
    change.lost += part_of_loss(k);
    group.note(contact, normal, change, count.log).kind = ImpactKind::ball;
  }
  for (std::size_t k = 0; k < walls.size(); ++k) {
    const double gain = gains[pairs.size() + k];
    if (!(gain > 0)) continue;
    Member& member = group.members[walls[k].member];
    FrictionChange change;
    if (rule.wall_friction > 0) {
      change =
          apply_wall_friction(member, walls[k].axis, walls[k].outwards * gain, rule.wall_friction);
    }
    count.lost += member.mass * change.lost;
    if (!count.log.wanted) continue;
    change.lost += part_of_loss(pairs.size() + k) / member.mass;
    note_wall({member.ball, walls[k].outwards > 0, true, 0, 0, gain}, walls[k].axis, member, change,
              count.log);
  }
}

}  // namespace carom::effects
