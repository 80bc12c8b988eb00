#include "contact/island_account.hpp"

#include <algorithm>
#include <utility>

namespace carom::contact {
namespace {

// Where turns are counted, the way of a ball from where it was, at the start or as it had flown,
// beyond the shorter one round: where heavy balls squeeze a light one out it is half a period or
// more.
Vec2 farther(const LastingIsland::Member& member, const Vec2& way, const Vec2& shorter,
             const Domain& domain, const Turns& turns) {
  Vec2 beyond{0, 0};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    if (turns[axis].empty()) continue;
    const auto turned = member.turned[axis] + (member.woken ? member.turned_flying[axis] : 0);
    beyond[axis] = way[axis] + domain.period[axis] * static_cast<double>(turned) - shorter[axis];
  }
  return beyond;
}

}  // namespace

double lost_by(const LastingIsland& island, const Balls& balls, const Domain& domain,
               const Turns& turns, const Vec2& acceleration) {
  double lost = 0;
  for (const LastingIsland::Member& member : island.members) {
    const Vec2 from = member.woken ? member.start : member.flown;
    const Vec2 was = member.woken ? member.before : member.flown_velocity + member.pulled;
    const double spin = balls.spin.size() > 0 ? balls.spin[member.ball] : 0;
    const double turning = spin * member.radius;
    const double turned_before = member.spin * member.radius;
    const double turned = (turned_before - turning) * (turned_before + turning) / 2;
    const Vec2 now =
        Vec2{balls.velocity[0][member.ball], balls.velocity[1][member.ball]} + member.pulled;
    const double moving = (was - now).dot(was + now) + turned;
    const Vec2 way = balls.at(member.ball) - from;
    const Vec2 shorter = nearest_image(way, domain);
    // The pull is the same at every image; what gravity gives is not.
    const double fallen = (acceleration + member.pull).dot(shorter) +
                          acceleration.dot(farther(member, way, shorter, domain, turns));
    lost += (moving / 2 + fallen) / member.inverse_mass;
  }
  return lost;
}

void note_contacts(const LastingIsland& island, const Balls& balls, const IslandOutcome& outcome,
                   ImpactLog& log) {
  const std::size_t first = log.impacts.size();
  const auto carried = std::count_if(outcome.normal.begin(), outcome.normal.end(),
                                     [](double impulse) { return impulse > 0; });
  // Where nothing carries an impulse, what was put back onto a wall stands with the nearest
  // contact.
  const auto nearer = [](const IslandContact& a, const IslandContact& b) { return a.gap < b.gap; };
  const auto nearest = static_cast<std::size_t>(
      std::min_element(island.contacts.begin(), island.contacts.end(), nearer) -
      island.contacts.begin());
  const bool put_back = carried == 0 && island.lost != 0;
  double shares = 0;
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    if (!(outcome.normal[k] > 0) && !(put_back && k == nearest)) continue;
    const IslandContact& c = island.contacts[k];
    const LastingIsland::Member& a = island.members[static_cast<std::size_t>(c.a)];
    const bool wall = island.sources[k].wall;
    Impact& impact = log.impacts.emplace_back();
    impact.time = log.time;
    impact.kind = outcome.bounced[k] == 0 ? ImpactKind::rest
                  : carried > 1           ? ImpactKind::joint
                  : wall                  ? ImpactKind::wall
                                          : ImpactKind::ball;
    impact.a = a.ball;
    impact.position = a.flown;
    impact.normal = island.frame.out(c.normal);
    impact.impulse = outcome.normal[k];
    impact.tangential = outcome.along[k];
    impact.distance = c.gap + balls.radius[a.ball];
    if (wall) {
      const std::size_t axis = impact.normal.x() != 0 ? 0 : 1;
      impact.wall = side_of(axis, impact.normal[axis] > 0);
    } else {
      const std::uint32_t b = island.sources[k].other;
      impact.b = b;
      impact.distance += balls.radius[b];
      if (b < a.ball) {
        std::swap(impact.a, impact.b);
        impact.position =
            c.b < 0 ? balls.at(b) : island.members[static_cast<std::size_t>(c.b)].flown;
        impact.normal = -impact.normal;
      }
    }
    Vec2 speed = a.flown_velocity + a.pulled + outcome.after[static_cast<std::size_t>(c.a)];
    if (c.b >= 0) {
      const auto b = static_cast<std::size_t>(c.b);
      const LastingIsland::Member& other = island.members[b];
      speed -= other.flown_velocity + other.pulled + outcome.after[b];
    }
    const double lost = outcome.normal[k] * speed.dot(island.frame.out(c.normal)) / 2;
    impact.energy_lost = std::max(0.0, lost);
    shares += impact.energy_lost;
  }
  // What no normal impulse has taken, as friction's, stands with the first.
  for (std::size_t k = first; k < log.impacts.size(); ++k) {
    double& part = log.impacts[k].energy_lost;
    part = shares > 0 ? island.lost * (part / shares) : k == first ? island.lost : 0;
  }
}

void note_woken(const LastingIsland& island, ImpactLog& log) {
  for (const LastingIsland::Member& member : island.members) {
    if (!member.woken) continue;
    Impact& impact = log.impacts.emplace_back();
    impact.time = log.time;
    impact.kind = ImpactKind::wake;
    impact.a = member.ball;
    impact.position = member.start;
  }
}

}  // namespace carom::contact
