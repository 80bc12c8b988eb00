#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "contact/contact_graph.hpp"

namespace carom::event {

/// The velocities of a group of touching bodies, and which of their contacts approach.
///
/// Holds: what is rounding is measured by the fastest that the two bodies were in this instant.
template <class S>
class GroupMotion {
 public:
  /// By contact: 1 if it is one of those chosen.
  using Chosen = std::vector<char>;

  /// Both must outlive it.
  GroupMotion(std::span<const Body<S>> bodies, const ContactGraph<S>& graph)
      : bodies_(bodies), graph_(graph), velocity_(bodies.size()), peak_(bodies.size()) {
    for (std::size_t k = 0; k < bodies.size(); ++k) velocity_[k] = bodies[k].velocity;
    note_peaks();
  }

  [[nodiscard]] const std::vector<Vec<S>>& velocities() const { return velocity_; }
  /// `note_peaks` follows a change that is not rounding.
  [[nodiscard]] std::vector<Vec<S>>& velocities() { return velocity_; }
  [[nodiscard]] Vec<S> velocity(int body) const {
    return body == kWall ? Vec<S>{S(0), S(0)} : velocity_[static_cast<std::size_t>(body)];
  }

  void note_peaks() {
    for (std::size_t k = 0; k < bodies_.size(); ++k) {
      const Vec<S>& v = velocity_[k];
      peak_[k] = larger(peak_[k], larger(absolute(v.x), absolute(v.y)));
    }
  }
  /// The sum, for the two bodies of a contact, of the largest component that each has had.
  [[nodiscard]] S peak(std::size_t contact) const {
    const Contact<S>& c = graph_.contact(contact);
    return peak_[static_cast<std::size_t>(c.a)] +
           (c.b == kWall ? S(0) : peak_[static_cast<std::size_t>(c.b)]);
  }

  /// All contacts that something can move.
  [[nodiscard]] Chosen mobile() const {
    Chosen all(graph_.size(), 0);
    for (std::size_t k = 0; k < graph_.size(); ++k) all[k] = graph_.mobility(k) > 0 ? 1 : 0;
    return all;
  }
  /// Contacts that approach, by more than rounding if so asked; nothing, if there are none.
  [[nodiscard]] std::optional<Chosen> approaching(bool beyond_rounding) const {
    const S noise = 64 * std::numeric_limits<S>::epsilon();
    Chosen chosen(graph_.size(), 0);
    bool any = false;
    for (std::size_t k = 0; k < graph_.size(); ++k) {
      const Contact<S>& c = graph_.contact(k);
      if (!(graph_.mobility(k) > 0)) continue;
      if (!(sharp_dot(c.r, velocity(c.b) - velocity(c.a)) < 0)) continue;
      if (beyond_rounding) {
        if (!(graph_.parting(k, velocity_) < -noise * peak(k))) continue;
      }
      chosen[k] = 1;
      any = true;
    }
    return any ? std::optional(chosen) : std::nullopt;
  }

  /// How fast each contact parts.
  [[nodiscard]] std::vector<S> partings() const {
    std::vector<S> result(graph_.size());
    for (std::size_t k = 0; k < graph_.size(); ++k) result[k] = graph_.parting(k, velocity_);
    return result;
  }

  /// The kinetic energy.
  [[nodiscard]] double energy() const {
    ExactSum<double> sum;
    for (std::size_t k = 0; k < bodies_.size(); ++k) {
      if (bodies_[k].inverse_mass == 0) continue;
      const auto mass = static_cast<double>(S(1 / bodies_[k].inverse_mass));
      const auto x = static_cast<double>(velocity_[k].x);
      const auto y = static_cast<double>(velocity_[k].y);
      sum.add(mass * (x * x) / 2);
      sum.add(mass * (y * y) / 2);
    }
    return sum.rounded();
  }

 private:
  std::span<const Body<S>> bodies_;
  const ContactGraph<S>& graph_;
  std::vector<Vec<S>> velocity_;
  std::vector<S> peak_;
};

}  // namespace carom::event
