#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include "contact/contact_graph.hpp"
#include "solvers/event/islands/found_island.hpp"
#include "solvers/event/order_by_place.hpp"

namespace carom::event {

/// Puts the balls and contacts of an island in an order that no numbering changes: balls by place,
/// contacts by their balls, those of one with what never moves by their direction.  Of two balls
/// the first in order is the first of their contact.
template <class S>
void put_in_order(FoundIsland<S>& island) {
  const auto sorted = [](std::size_t n, const auto& before) {
    std::vector<std::size_t> order(n);
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(), before);
    return order;
  };
  const auto rearrange = [](auto& column, const std::vector<std::size_t>& order) {
    auto old = column;
    for (std::size_t k = 0; k < order.size(); ++k) column[k] = std::move(old[order[k]]);
  };
  const std::vector<std::size_t> order =
      sorted(island.members.size(), [&](std::size_t one, std::size_t other) {
        return precedes_by_place(island.places[one], island.places[other]);
      });
  rearrange(island.members, order);
  rearrange(island.places, order);
  rearrange(island.support, order);
  rearrange(island.bodies, order);
  rearrange(island.gravity, order);
  if (!island.left_out.empty()) rearrange(island.left_out, order);
  std::vector<int> number(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) number[order[k]] = static_cast<int>(k);
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    ConeContact& c = island.contacts[k];
    c.a = number[static_cast<std::size_t>(c.a)];
    if (c.b == kWall) continue;
    c.b = number[static_cast<std::size_t>(c.b)];
    if (c.a < c.b) continue;
    std::swap(c.a, c.b);
    c.normal = -c.normal;
    island.near[k].r = -island.near[k].r;
  }
  const std::vector<std::size_t> in_turn =
      sorted(island.contacts.size(), [&](std::size_t one, std::size_t other) {
        const ConeContact& c = island.contacts[one];
        const ConeContact& d = island.contacts[other];
        if (c.a != d.a) return c.a < d.a;
        if (c.b != d.b) return c.b < d.b;
        return precedes_by_place(c.normal, d.normal);
      });
  rearrange(island.contacts, in_turn);
  rearrange(island.near, in_turn);
  rearrange(island.touches, in_turn);
}

}  // namespace carom::event
