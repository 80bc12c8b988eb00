#include "view/lanes.hpp"

#include <algorithm>
#include <numeric>

namespace carom {
namespace {

/// The entries of a worker in one frame that end a phase or the frame, and where they begin.
struct InFrame {
  std::vector<TimelineEntry>::const_iterator begin;
  std::vector<TimelineEntry>::const_iterator end;
};

InFrame entries_of(const std::vector<TimelineEntry>& lane, std::uint64_t frame) {
  auto first = std::lower_bound(
      lane.begin(), lane.end(), frame,
      [](const TimelineEntry& entry, std::uint64_t number) { return entry.frame < number; });
  const auto last = std::find_if(
      first, lane.end(), [frame](const TimelineEntry& entry) { return entry.frame != frame; });
  if (first != last && first->phase == 0) ++first;
  return {first, last};
}

/// The passages of one frame, in their order, from what each worker noted of it.
void add_frame(const Timeline& timeline, const TimelineEntry& control, Lanes& lanes) {
  // The workers wait there already: the control thread is the last to arrive.
  lanes.passages.push_back({control.begin, 0, 0});
  const std::size_t first = lanes.passages.size();
  for (std::size_t worker = 0; worker < lanes.workers.size(); ++worker) {
    const InFrame entries = entries_of(timeline.workers[worker], control.frame);
    std::size_t place = first;
    for (auto entry = entries.begin; entry != entries.end; ++entry, ++place) {
      if (entry->arrived > entry->begin)
        lanes.workers[worker].push_back({entry->begin, entry->arrived});
      if (place == lanes.passages.size()) lanes.passages.push_back({0, entry->phase, worker});
      Passage& passage = lanes.passages[place];
      if (entry->arrived > passage.at) {
        passage.at = entry->arrived;
        passage.last = worker;
      }
    }
  }
}

}  // namespace

Lanes lanes_of(const Timeline& timeline) {
  Lanes lanes;
  if (timeline.control.empty()) return lanes;
  const std::uint64_t newest = timeline.control.back().frame;
  std::size_t workers = timeline.workers.size();
  while (workers > 0 && (timeline.workers[workers - 1].empty() ||
                         timeline.workers[workers - 1].back().frame != newest))
    --workers;
  lanes.begin = timeline.control.front().begin;
  lanes.frame_done = static_cast<std::uint32_t>(timeline.barriers.size() - 1);
  lanes.workers.resize(workers);
  for (const TimelineEntry& frame : timeline.control) add_frame(timeline, frame, lanes);
  lanes.end = lanes.passages.back().at;
  return lanes;
}

Lanes part_of(const Lanes& lanes, std::int64_t begin, std::int64_t end) {
  Lanes part;
  part.begin = begin;
  part.end = end;
  part.frame_done = lanes.frame_done;
  for (const Passage& passage : lanes.passages) {
    if (passage.at >= begin && passage.at <= end) part.passages.push_back(passage);
  }
  const auto cut = [&](const std::vector<Stretch>& lane) {
    std::vector<Stretch> result;
    for (const Stretch& each : lane) {
      const Stretch inside{std::max(each.begin, begin), std::min(each.end, end)};
      if (inside.begin < inside.end) result.push_back(inside);
    }
    return result;
  };
  for (const std::vector<Stretch>& worker : lanes.workers) part.workers.push_back(cut(worker));
  return part;
}

double computing_in(const std::vector<Stretch>& lane, double begin, double end) {
  auto each = std::partition_point(lane.begin(), lane.end(), [begin](const Stretch& stretch) {
    return static_cast<double>(stretch.end) <= begin;
  });
  double sum = 0;
  for (; each != lane.end() && static_cast<double>(each->begin) < end; ++each) {
    sum += std::min(end, static_cast<double>(each->end)) -
           std::max(begin, static_cast<double>(each->begin));
  }
  return sum;
}

double share_of_waiting(const Lanes& lanes) {
  const auto begin = static_cast<double>(lanes.begin);
  const auto end = static_cast<double>(lanes.end);
  const double all = (end - begin) * static_cast<double>(lanes.workers.size());
  if (!(all > 0)) return 0;
  double computed = 0;
  for (const std::vector<Stretch>& worker : lanes.workers)
    computed += computing_in(worker, begin, end);
  return 1 - computed / all;
}

std::size_t most_often_last(const Lanes& lanes) {
  std::vector<std::size_t> times(lanes.workers.size());
  for (const Passage& passage : lanes.passages) {
    if (passage.barrier != 0 && passage.barrier != lanes.frame_done) ++times[passage.last];
  }
  const auto most = std::max_element(times.begin(), times.end());
  if (most == times.end() || *most == 0) return lanes.workers.size();
  return static_cast<std::size_t>(most - times.begin());
}

std::vector<std::size_t> busiest(const std::vector<double>& computed, std::size_t count) {
  std::vector<std::size_t> order(computed.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  count = std::min(count, order.size());
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return computed[a] > computed[b]; });
  order.resize(count);
  std::sort(order.begin(), order.end());
  return order;
}

}  // namespace carom
