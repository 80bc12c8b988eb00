#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include "solvers/event/huge_pages.hpp"
#include "solvers/event/word_search.hpp"

namespace carom::event {

/// Many short lists of indices, the first `K` of each in one place.
///
/// Holds: a list is a chain of nodes; all but the last are full.
template <std::uint32_t K>
class ShortLists {
  static_assert((K + 2) % kWords == 0 && K < 32);

 public:
  struct alignas((K + 2) * 4) Node {
    std::uint32_t item[K];
    std::uint32_t count = 0;
    std::uint32_t next = 0;
  };

  void reset(std::size_t lists) {
    nodes_.assign(lists, Node{});
    free_.clear();
  }

  [[nodiscard]] const Node& first(std::uint32_t list) const { return nodes_[list]; }
  /// The node after `node`.
  /// REQUIRES: it has one (`next` is not 0).
  [[nodiscard]] const Node& after(const Node& node) const { return nodes_[node.next]; }

  template <class Visit>
  void each(std::uint32_t list, Visit visit) const {
    for (const Node* node = &nodes_[list];; node = &nodes_[node->next]) {
      for (std::uint32_t n = 0; n < node->count; ++n) visit(node->item[n]);
      if (node->next == 0) return;
    }
  }

  /// Puts the items of a list at the beginning of `into`, which grows where it must, and has K
  /// words after them; gives their number.
  std::uint32_t copy(std::uint32_t list, std::vector<std::uint32_t>& into) const {
    std::uint32_t count = 0;
    for (const Node* node = &nodes_[list];; node = &nodes_[node->next]) {
      if (into.size() < count + 2 * K) into.resize(2 * (into.size() + K));
      std::memcpy(&into[count], node->item, sizeof node->item);
      count += node->count;
      if (node->next == 0) return count;
    }
  }

  void add(std::uint32_t list, std::uint32_t item) {
    std::uint32_t at = list;
    while (nodes_[at].next != 0) at = nodes_[at].next;
    if (nodes_[at].count == K) {
      const std::uint32_t fresh = new_node();
      nodes_[at].next = fresh;
      at = fresh;
    }
    nodes_[at].item[nodes_[at].count++] = item;
  }

  /// Takes `item` out of the list, where it is in it.
  void remove(std::uint32_t list, std::uint32_t item) {
    std::uint32_t at = list;
    std::uint32_t slot = find(nodes_[at], item);
    while (slot == K) {
      if (nodes_[at].next == 0) return;
      at = nodes_[at].next;
      slot = find(nodes_[at], item);
    }
    std::uint32_t before = at;
    std::uint32_t last = at;
    while (nodes_[last].next != 0) {
      before = last;
      last = nodes_[last].next;
    }
    nodes_[at].item[slot] = nodes_[last].item[--nodes_[last].count];
    if (nodes_[last].count == 0 && last != list) {
      if (before == last) {  // the item was alone in the last node: find who points there
        before = list;
        while (nodes_[before].next != last) before = nodes_[before].next;
      }
      nodes_[before].next = 0;
      free_.push_back(last);
    }
  }

  void assign(std::uint32_t list, const std::uint32_t* items, std::uint32_t count) {
    if (nodes_[list].next != 0) clear(list);
    if (count > K) {
      nodes_[list].count = 0;
      for (std::uint32_t n = 0; n < count; ++n) add(list, items[n]);
      return;
    }
    for (std::uint32_t n = 0; n < count; ++n) nodes_[list].item[n] = items[n];
    nodes_[list].count = count;
  }

  void clear(std::uint32_t list) {
    for (std::uint32_t at = nodes_[list].next; at != 0;) {
      free_.push_back(at);
      at = nodes_[at].next;
    }
    nodes_[list].count = 0;
    nodes_[list].next = 0;
  }

 private:
  /// Where the node has the item, K: nowhere.  Without a branch: it cannot be foreseen.
  static std::uint32_t find(const Node& node, std::uint32_t item) {
    // The last two of its words are no items.
    const auto* const words = reinterpret_cast<const std::uint32_t*>(&node);
    std::uint32_t found = std::uint32_t{1} << K;
    for (std::uint32_t n = 0; n < K + 2; n += kWords) {
      found |= (equal_words(words + n, item) << n) & ((std::uint32_t{1} << node.count) - 1);
    }
    return static_cast<std::uint32_t>(std::countr_zero(found));
  }

  std::uint32_t new_node() {
    if (!free_.empty()) {
      const std::uint32_t at = free_.back();
      free_.pop_back();
      nodes_[at] = Node{};
      return at;
    }
    // Few lists are long: no room for twice as many nodes is asked for.
    if (nodes_.size() == nodes_.capacity()) nodes_.reserve(nodes_.size() + nodes_.size() / 16 + 16);
    nodes_.emplace_back();
    return static_cast<std::uint32_t>(nodes_.size() - 1);
  }

  HugeVector<Node> nodes_;
  std::vector<std::uint32_t> free_;
};

}  // namespace carom::event
