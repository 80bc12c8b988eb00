#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <vector>

#include "solvers/event/event_queue_body.hpp"
#include "solvers/event/short_lists.hpp"

namespace carom::event::event_queue_test {
namespace {

using Words = std::vector<std::uint32_t>;

std::uint32_t below(std::uint32_t limit) {
  return *rc::gen::inRange(0U, limit);
}

// Broken, it fails: a list that looks at one node only, or takes what lies behind its end for
// items.
template <std::uint32_t K>
void lists_hold_what_was_put_in() {
  constexpr std::uint32_t kLists = 5;
  ShortLists<K> lists;
  lists.reset(kLists);
  std::vector<std::set<std::uint32_t>> expected(kLists);
  Words copied;
  const std::uint32_t steps = below(150);
  for (std::uint32_t step = 0; step < steps; ++step) {
    const std::uint32_t list = below(kLists);
    auto& items = expected[list];
    const std::uint32_t item = below(3 * K);
    switch (below(8)) {
      case 0: {
        const Words all(items.begin(), items.end());
        const auto some = static_cast<std::uint32_t>(all.size() / 2);
        lists.assign(list, all.data(), some);
        items = {all.begin(), all.begin() + some};
        break;
      }
      case 1:
      case 2:
        lists.remove(list, item);
        items.erase(item);
        break;
      default:
        if (items.insert(item).second) lists.add(list, item);
    }
  }
  for (std::uint32_t list = 0; list < kLists; ++list) {
    Words seen;
    lists.each(list, [&](std::uint32_t item) { seen.push_back(item); });
    const std::uint32_t count = lists.copy(list, copied);
    RC_ASSERT(Words(copied.begin(), copied.begin() + count) == seen);
    std::sort(seen.begin(), seen.end());
    RC_ASSERT(seen == Words(expected[list].begin(), expected[list].end()));
  }
}

RC_GTEST_PROP(EventQueue, ShortListsHoldWhatWasPutIn, ()) {
  lists_hold_what_was_put_in<6>();
  lists_hold_what_was_put_in<14>();
}

RC_GTEST_PROP(EventQueue, WordsAreFoundAmongTheirs, ()) {
  const std::uint32_t count = below(30);
  Words words(count + kWords, 1000);
  for (std::uint32_t n = 0; n < count; ++n) words[n] = below(40);
  const std::uint32_t word = below(40);
  RC_ASSERT(is_among(words.data(), count, word) ==
            (std::find(words.begin(), words.begin() + count, word) != words.begin() + count));
}

// Many balls at few times, so that a bucket holds none, few and more than are put in order by
// counting, and equal ones.
RC_GTEST_PROP(EventQueue, TheAgendaGivesTheEarliestThatIsStillWanted, ()) {
  using Queue = EventQueue<Clock<double>>;
  Queue queue;
  const FixedTime span = *rc::gen::inRange<FixedTime>(1, 5000);
  queue.reset(0, *rc::gen::inRange<FixedTime>(1, 2000), 4U << below(4));
  std::map<Index, FixedTime> due;
  const auto wanted = [&](const Queue::Entry& entry) {
    const auto at = due.find(entry.ball);
    return at != due.end() && at->second == entry.time;
  };
  const auto unprepared = [](auto, auto, auto) {};
  FixedTime now = 0;
  const std::uint32_t balls = 1 + below(400);
  const auto add = [&](Index ball) {
    due[ball] = now + *rc::gen::inRange<FixedTime>(0, span);
    queue.add(due[ball], ball);
  };
  for (Index ball = 0; ball < balls; ++ball) add(ball);
  for (int step = 0; step < 300 && !due.empty(); ++step) {
    const FixedTime earliest =
        std::min_element(due.begin(), due.end(), [](const auto& a, const auto& b) {
          return a.second < b.second;
        })->second;
    Queue::Entry entry{};
    do {
      const Queue::Entry* next = queue.first(now + span, wanted, unprepared);
      RC_ASSERT(next != nullptr);
      entry = *next;
      queue.drop_first();
    } while (!wanted(entry));
    RC_ASSERT(entry.time == earliest);
    now = entry.time;
    due.erase(entry.ball);
    for (std::uint32_t more = below(3); more > 0; --more) add(below(balls));
  }
}

}  // namespace
}  // namespace carom::event::event_queue_test
