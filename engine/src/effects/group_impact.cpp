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

/// The joint impact that ends those of a group, and what is booked of it.
class EndOfImpacts {
 public:
  EndOfImpacts(ContactGroup& group, const CollisionRule& rule, ImpactCount& count)
      : group_(group), rule_(rule), count_(count) {}

  void resolve(const Domain& domain);
  // Friction acts by the impulse that each contact got; the log is told.
  void book_pairs();
  void book_walls();

 private:
  using Velocity = event::Vec<double>;
  using Contacts = std::vector<event::Contact<double>>;

  void add_pairs(Contacts& contacts);
  void add_walls(const Domain& domain, Contacts& contacts);
  /// What the impact took, by the contact's part in all of it.
  [[nodiscard]] double loss_of(std::size_t contact) const {
    return all_gains_ > 0 ? lost_ * gains_[contact] / all_gains_ : 0;
  }

  ContactGroup& group_;
  const CollisionRule& rule_;
  ImpactCount& count_;
  std::vector<std::size_t> pairs_;  // that touch: the first contacts, of the group's
  std::vector<WallContact> walls_;  // the others
  std::vector<double> gains_;       // by contact
  double all_gains_ = 0;
  double lost_ = 0;
};

void EndOfImpacts::add_pairs(Contacts& contacts) {
  for (std::size_t k = 0; k < group_.contacts.size(); ++k) {
    const Contact& contact = group_.contacts[k];
    if (!contact.touching) continue;
    pairs_.push_back(k);
    contacts.push_back({static_cast<int>(contact.a), static_cast<int>(contact.b),
                        Velocity{contact.line.r.x(), contact.line.r.y()}, rule_.restitution});
  }
}

void EndOfImpacts::add_walls(const Domain& domain, Contacts& contacts) {
  for (std::size_t m = 0; m < group_.members.size(); ++m) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      for (const double outwards : {-1.0, 1.0}) {
        if (!at_wall(group_.members[m], domain, axis, outwards)) continue;
        walls_.push_back({m, axis, outwards});
        contacts.push_back({static_cast<int>(m), event::kWall,
                            axis == 0 ? Velocity{outwards, 0} : Velocity{0, outwards},
                            rule_.wall_restitution});
      }
    }
  }
}

void EndOfImpacts::resolve(const Domain& domain) {
  std::vector<event::Body<double>> bodies;
  for (const Member& member : group_.members) {
    bodies.push_back({Velocity{member.velocity.x(), member.velocity.y()}, member.inverse_mass});
  }
  Contacts contacts;
  add_pairs(contacts);
  add_walls(domain, contacts);
  event::JointImpact<double> impact(bodies, contacts);
  const event::JointReport report = impact.resolve();
  gains_ = impact.gains();
  for (const double gain : gains_) all_gains_ += gain;
  lost_ = report.lost;
  count_.ball_ball += static_cast<std::uint64_t>(report.impacts);
  count_.ball_wall += static_cast<std::uint64_t>(report.walls);
  count_.lost += report.lost;
  for (std::size_t m = 0; m < bodies.size(); ++m) {
    group_.members[m].velocity = {bodies[m].velocity.x, bodies[m].velocity.y};
  }
}

void EndOfImpacts::book_pairs() {
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    if (!(gains_[k] > 0)) continue;
    const Contact& contact = group_.contacts[pairs_[k]];
    const double normal = gains_[k] / contact.inverse_masses;
    FrictionChange change;
    if (rule_.friction > 0) {
      change = apply_friction(group_.members[contact.a], group_.members[contact.b], contact.line,
                              normal, rule_.friction);
    }
    count_.lost += change.lost;
    if (!count_.log.wanted) continue;
    change.lost += loss_of(k);
    group_.note(contact, normal, change, count_.log).kind = ImpactKind::ball;
  }
}

void EndOfImpacts::book_walls() {
  for (std::size_t k = 0; k < walls_.size(); ++k) {
    const WallContact& wall = walls_[k];
    const std::size_t contact = pairs_.size() + k;
    const double gain = gains_[contact];
    if (!(gain > 0)) continue;
    Member& member = group_.members[wall.member];
    FrictionChange change;
    if (rule_.wall_friction > 0) {
      change = apply_wall_friction(member, wall.axis, wall.outwards * gain, rule_.wall_friction);
    }
    count_.lost += member.mass * change.lost;
    if (!count_.log.wanted) continue;
    change.lost += loss_of(contact) / member.mass;
    note_wall({member.ball, wall.outwards > 0, true, 0, 0, gain}, wall.axis, member, change,
              count_.log);
  }
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
  EndOfImpacts end(group, rule, count);
  end.resolve(domain);
  end.book_pairs();
  end.book_walls();
}

}  // namespace carom::effects
