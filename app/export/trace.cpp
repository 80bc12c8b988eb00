#include "export/trace.hpp"

#include <fmt/format.h>

#include <iterator>

#include "export/json_text.hpp"

namespace carom {
namespace {

/// A moment in microseconds, in whole 64ths: sums of such numbers are exact in a double.
double microseconds(std::int64_t nanoseconds) {
  constexpr std::int64_t kThousand = 1000;
  constexpr std::int64_t kPart = 64;
  const std::int64_t whole = nanoseconds / kThousand;
  const std::int64_t parts = nanoseconds % kThousand * kPart / kThousand;
  return static_cast<double>(whole) + static_cast<double>(parts) / kPart;
}

class Writer {
 public:
  std::string take() { return std::move(text_) + "\n]}\n"; }

  void begin(const std::string& scene) {
    text_ = fmt::format(
        "{{\"displayTimeUnit\":\"ms\",\"otherData\":{{\"program\":\"carom\",\"scene\":{}}},"
        "\"traceEvents\":[\n"
        R"({{"ph":"M","pid":1,"tid":1,"name":"process_name","args":{{"name":"carom"}}}})",
        json_text(scene));
  }
  void thread(std::size_t number, const std::string& name) {
    add(fmt::format(R"({{"ph":"M","pid":1,"tid":{},"name":"thread_name","args":{{"name":"{}"}}}})",
                    number, name));
    add(fmt::format(
        R"({{"ph":"M","pid":1,"tid":{},"name":"thread_sort_index","args":{{"sort_index":{}}}}})",
        number, number));
  }
  void slice(std::size_t thread, const std::string& category, const std::string& name,
             std::int64_t begin, std::int64_t end, std::uint64_t frame) {
    const double from = microseconds(begin);
    add(fmt::format(R"({{"ph":"X","pid":1,"tid":{},"ts":{},"dur":{},"cat":"{}","name":"{}",)"
                    R"("args":{{"frame":{}}}}})",
                    thread, from, microseconds(end) - from, category, name, frame));
  }
  void instant(std::size_t thread, const std::string& name, std::int64_t at) {
    add(fmt::format(R"({{"ph":"i","s":"t","pid":1,"tid":{},"ts":{},"name":"{}"}})", thread,
                    microseconds(at), name));
  }

 private:
  void add(const std::string& event) { text_ += ",\n" + event; }

  std::string text_;
};

}  // namespace

std::string trace_json(const Timeline& timeline, const std::string& scene) {
  constexpr std::size_t kControl = 1;  // viewers drop a thread 0
  Writer writer;
  writer.begin(scene);
  writer.thread(kControl, "control");
  for (std::size_t k = 0; k < timeline.workers.size(); ++k) {
    writer.thread(k + 2, fmt::format("worker {}", k));
  }
  for (const TimelineEntry& entry : timeline.control) {
    writer.slice(kControl, "frame", timeline.barriers.front(), entry.begin, entry.left,
                 entry.frame);
    writer.instant(kControl, timeline.barriers.back(), entry.left);
  }
  for (std::size_t k = 0; k < timeline.workers.size(); ++k) {
    for (const TimelineEntry& entry : timeline.workers[k]) {
      const std::string& barrier = timeline.barriers[entry.phase];
      const bool phase = entry.phase > 0 && entry.phase + 1 < timeline.barriers.size();
      if (phase) writer.slice(k + 2, "phase", barrier, entry.begin, entry.arrived, entry.frame);
      writer.slice(k + 2, "wait", "wait " + barrier, entry.arrived, entry.left, entry.frame);
    }
  }
  return writer.take();
}

}  // namespace carom
