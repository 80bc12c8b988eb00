#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "contact/disjoint_sets.hpp"
#include "contact/impulse_guess.hpp"
#include "contact/index.hpp"
#include "numbers/exact_sum.hpp"
#include "numbers/scalar.hpp"

namespace carom::event {

/// A ball of a group of touching balls; an inverse mass of 0 is a fixed one.
template <class S>
struct Body {
  Vec<S> velocity;
  S inverse_mass;
};

inline constexpr int kWall = -1;

/// Two bodies that touch, or a body and a wall.
template <class S>
struct Contact {
  int a;
  int b;     ///< a body, or kWall
  Vec<S> r;  ///< from the centre of a to that of b, or any length along the axis towards the wall
  S restitution;
};

/// Who touches whom in a group, and what impulses along the contacts' normals do to its bodies.
/// Holds: every sum over contacts or bodies is rounded once, so the numbering of bodies and
/// contacts, the sides a and b, mirrors and swapped axes leave the bits as they are.
template <class S>
class ContactGraph {
 public:
  ContactGraph(std::span<const Body<S>> bodies, std::span<const Contact<S>> contacts)
      : bodies_(bodies), contacts_(contacts), at_body_(bodies.size()) {
    for (std::size_t k = 0; k < contacts.size(); ++k) {
      const Contact<S>& c = contacts[k];
      const S length = root(S(c.r.x * c.r.x + c.r.y * c.r.y));
      normals_.push_back({c.r.x / length, c.r.y / length});
      at_body_[index(c.a)].push_back({k, false});
      if (c.b != kWall) at_body_[index(c.b)].push_back({k, true});
    }
  }

  std::size_t size() const { return contacts_.size(); }
  const Contact<S>& contact(std::size_t k) const { return contacts_[k]; }
  const Vec<S>& normal(std::size_t k) const { return normals_[k]; }
  std::size_t bodies() const { return bodies_.size(); }

  S inverse_mass(int body) const {
    return body == kWall ? S(0) : bodies_[index(body)].inverse_mass;
  }
  /// How fast one impulse along contact k would part it, were it alone.
  S mobility(std::size_t k) const {
    return inverse_mass(contacts_[k].a) + inverse_mass(contacts_[k].b);
  }

  /// How fast the bodies of contact k part when they move as `motion` says; less than 0: they
  /// approach.
  S parting(std::size_t k, const std::vector<Vec<S>>& motion) const {
    const Vec<S>& a = motion[index(contacts_[k].a)];
    const Vec<S> b = contacts_[k].b == kWall ? Vec<S>{S(0), S(0)} : motion[index(contacts_[k].b)];
    return sharp_dot(normals_[k], b - a);
  }

  /// The total impulse on each body of `impulses` along the contacts' normals.
  std::vector<Vec<S>> totals(const std::vector<S>& impulses) const {
    std::vector<Vec<S>> result(bodies_.size());
    ExactSum<S> x;
    ExactSum<S> y;
    for (std::size_t body = 0; body < bodies_.size(); ++body) {
      x.clear();
      y.clear();
      for (const End& end : at_body_[body]) {
        const S impulse = end.is_b ? impulses[end.contact] : S(-impulses[end.contact]);
        if (impulse == 0) continue;
        x.add(impulse * normals_[end.contact].x);
        y.add(impulse * normals_[end.contact].y);
      }
      result[body] = {x.rounded(), y.rounded()};
    }
    return result;
  }

  /// How fast those impulses make each contact part.
  std::vector<S> response(const std::vector<S>& impulses) const {
    std::vector<Vec<S>> motion = totals(impulses);
    for (std::size_t body = 0; body < bodies_.size(); ++body) {
      motion[body] = bodies_[body].inverse_mass * motion[body];
    }
    std::vector<S> result(size());
    for (std::size_t k = 0; k < size(); ++k) result[k] = parting(k, motion);
    return result;
  }

  /// How fast an impulse at each contact parts each, in double.
  ResponseMatrix response_matrix() const {
    ResponseMatrix result(size());
    for (std::size_t body = 0; body < bodies_.size(); ++body) {
      const auto mobility = static_cast<double>(bodies_[body].inverse_mass);
      if (mobility == 0) continue;
      for (const End& one : at_body_[body]) {
        const Vec<S>& n = normals_[one.contact];
        for (const End& other : at_body_[body]) {
          const Vec<S>& m = normals_[other.contact];
          const double along = mobility * static_cast<double>(S(n.x * m.x + n.y * m.y));
          result.at(one.contact, other.contact) += one.is_b == other.is_b ? along : -along;
        }
      }
    }
    return result;
  }

  /// For each contact a number of the set it is in: `chosen` contacts that share a body that can
  /// move, but for two that meet there at right angles along the axes, which do not feel each
  /// other.
  std::vector<std::size_t> coupled_sets(const std::vector<char>& chosen) const {
    DisjointSets sets;
    sets.reset(size());
    for (std::size_t body = 0; body < bodies_.size(); ++body) {
      if (bodies_[body].inverse_mass == 0) continue;
      for (const End& one : at_body_[body]) {
        for (const End& other : at_body_[body]) {
          if (chosen[one.contact] && chosen[other.contact] && feel(one.contact, other.contact)) {
            sets.merge(static_cast<std::uint32_t>(one.contact),
                       static_cast<std::uint32_t>(other.contact));
          }
        }
      }
    }
    std::vector<std::size_t> set(size());
    for (std::size_t k = 0; k < size(); ++k) set[k] = sets.find(static_cast<std::uint32_t>(k));
    return set;
  }

 private:
  struct End {
    std::size_t contact;
    bool is_b;
  };

  bool feel(std::size_t one, std::size_t other) const {
    const Vec<S>& r = normals_[one];
    const Vec<S>& q = normals_[other];
    return !((r.x == 0 && q.y == 0) || (r.y == 0 && q.x == 0));
  }

  std::span<const Body<S>> bodies_;
  std::span<const Contact<S>> contacts_;
  std::vector<Vec<S>> normals_;
  std::vector<std::vector<End>> at_body_;
};

}  // namespace carom::event
