#include "carom/crew.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <mutex>
#include <new>
#include <optional>
#include <system_error>
#include <utility>

#include "carom/barrier.hpp"
#include "crew/thread.hpp"
#include "crew/timeline_recorder.hpp"

namespace carom {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kFreeWorkersPerCore = 8;

/// What went wrong in the workers: of several failures the one of the lowest worker, which does not
/// depend on who was first, since all of a phase get to its end.
class Failure {
 public:
  void add(std::size_t worker, std::exception_ptr exception) {
    const std::scoped_lock lock(mutex_);
    if (exception_ && worker_ < worker) return;
    worker_ = worker;
    exception_ = std::move(exception);
  }
  /// REQUIRES: no worker runs.
  void rethrow() const {
    if (exception_) std::rethrow_exception(exception_);
  }

 private:
  std::mutex mutex_;
  std::size_t worker_ = 0;
  std::exception_ptr exception_;
};

}  // namespace

class Crew::Implementation {
 public:
  Implementation(std::size_t workers, std::vector<Phase> phases)
      : phases_(std::move(phases)), spent_(phases_.size(), 0.0) {
    for (std::size_t i = 0; i < phases_.size(); ++i) {
      phase_done_.push_back(std::make_unique<Barrier>(0, [this, i] { finish(i); }));
    }
    try {
      start(workers);
    } catch (...) {
      stop();
      throw;
    }
  }
  ~Implementation() { stop(); }
  Implementation(const Implementation&) = delete;
  Implementation& operator=(const Implementation&) = delete;

  void do_frame(std::size_t first) {
    current_ = first;
    phase_began_ = Clock::now();
    const Clock::time_point began = phase_began_;
    if (recorder_ ? meet_recorded()
                  : do_frame_.arrive_and_wait() && frame_done_.arrive_and_wait()) {
      if (count_ > 1) frames_ += Clock::now() - began;
      return;
    }
    stop();
    failure_.rethrow();
  }

  void resize(std::size_t workers) {
    if (workers < threads_.size()) {
      end(workers);
    } else if (workers > threads_.size()) {
      const std::size_t before = threads_.size();
      try {
        start(workers);
      } catch (...) {
        end(before);
        throw;
      }
    }
  }

  [[nodiscard]] std::size_t workers() const { return threads_.size(); }

  [[nodiscard]] std::vector<BarrierStatus> barriers() const {
    std::vector<BarrierStatus> result{{"do_frame", do_frame_.parties()}};
    for (std::size_t i = 0; i < phases_.size(); ++i) {
      result.push_back({phases_[i].name, phase_done_[i]->parties()});
    }
    result.push_back({"frame_done", frame_done_.parties()});
    return result;
  }

  [[nodiscard]] Effort effort() const {
    const auto seconds = [](Clock::duration spent) {
      return std::chrono::duration<double>(spent).count();
    };
    return {seconds(frames_), seconds(Clock::duration(computing_.load()))};
  }

  [[nodiscard]] Seconds seconds() const {
    Seconds result;
    for (std::size_t i = 0; i < phases_.size(); ++i) {
      result.emplace_back(phases_[i].name, spent_[i]);
    }
    return result;
  }

  void record_timeline(std::size_t frames) {
    recorder_ = frames == 0 ? nullptr : std::make_shared<TimelineRecorder>(frames);
    if (recorder_) recorder_->set_workers(threads_.size());
  }

  [[nodiscard]] Timeline timeline(std::size_t frames) const {
    Timeline result = recorder_ ? recorder_->timeline(frames) : Timeline{};
    for (const BarrierStatus& barrier : barriers()) result.barriers.push_back(barrier.name);
    return result;
  }

 private:
  /// The life of a worker.
  void work(std::size_t index) {
    WorkerTimeline timeline(index);
    const auto frame_done = static_cast<std::uint32_t>(phases_.size() + 1);
    try {
      while (do_frame_.arrive_and_wait()) {
        if (index >= count_) {
          timeline.end();
          change_parties(&Barrier::leave);
          return;
        }
        timeline.begin_frame(recorder_);
        Clock::duration busy{0};
        while (current_ != Phase::kFrameDone) {
          const std::size_t phase = current_;
          if (count_ == 1) {
            phases_[phase].work(Share{index, count_});
          } else {
            const Clock::time_point began = Clock::now();
            phases_[phase].work(Share{index, count_});
            busy += Clock::now() - began;
          }
          timeline.arrive();
          if (!phase_done_[phase]->arrive_and_wait()) return;
          timeline.leave(static_cast<std::uint32_t>(phase + 1));
        }
        if (busy.count() != 0) computing_ += busy.count();
        timeline.arrive_at_frame_done(frame_done);
        // Only the control thread waits for the end of the frame: the next thing for a worker
        // is to wait for the order of the next one, which that thread gives after the end.
        if (!frame_done_.arrive()) return;
      }
    } catch (...) {
      failure_.add(index, std::current_exception());
      cancel();
    }
  }

  [[nodiscard]] bool meet_recorded() {
    TimelineRing& ring = recorder_->control();
    ring.begin_frame(recorder_->frames(), recorder_->most_entries());
    const std::int64_t begin = recorder_->now();
    if (!do_frame_.arrive_and_wait()) return false;
    const std::int64_t begun = recorder_->now();
    if (!frame_done_.arrive_and_wait()) return false;
    recorder_->end_frame();
    ring.add({begin, begun, recorder_->ended(), recorder_->frame() - 1, 0});
    return true;
  }

  /// Run by the last worker to end a phase, while the others wait.
  void finish(std::size_t phase) {
    current_ = phases_[phase].finish();
    const Clock::time_point now = Clock::now();
    spent_[phase] += std::chrono::duration<double>(now - phase_began_).count();
    phase_began_ = now;
  }

  void change_parties(void (Barrier::*change)()) {
    (do_frame_.*change)();
    for (const auto& barrier : phase_done_) ((*barrier).*change)();
    (frame_done_.*change)();
  }

  void cancel() {
    do_frame_.cancel();
    for (const auto& barrier : phase_done_) barrier->cancel();
    frame_done_.cancel();
  }

  /// The first few workers of each core go wherever the system has room.  The many beyond are dealt
  /// to the cores, since all of them take turns in every phase and the phase lasts as long as the
  /// fullest core needs; the system alone leaves three quarters of a thousand on one of two cores.
  [[nodiscard]] std::optional<int> core_of(std::size_t worker) const {
    if (worker < kFreeWorkersPerCore * cores_.size() || cores_.empty()) return {};
    return cores_[worker % cores_.size()];
  }

  /// Starts workers up to `workers`.
  void start(std::size_t workers) {
    threads_.reserve(workers);
    count_ = workers;
    if (recorder_) recorder_->set_workers(workers);
    for (std::size_t i = threads_.size(); i < workers; ++i) {
      change_parties(&Barrier::join);
      std::string reason;
      try {
        threads_.emplace_back([this, i] { work(i); }, core_of(i));
        continue;
      } catch (const std::system_error& error) {
        reason = error.code().message();
      } catch (const std::bad_alloc&) {
        reason = "out of memory";
      }
      if (i > 0) change_parties(&Barrier::leave);  // else the crew never was, and is cancelled
      throw CrewError("the system gave only " + std::to_string(i) + " of " +
                      std::to_string(workers) + " worker threads (" + reason +
                      "): use fewer, as in --workers 2");
    }
  }

  /// Ends the workers from number `workers` on: they are let through do_frame and leave, the others
  /// find a frame of no phases.
  void end(std::size_t workers) {
    count_ = workers;
    if (workers == threads_.size()) return;
    current_ = Phase::kFrameDone;
    (void)do_frame_.arrive_and_wait();
    (void)frame_done_.arrive_and_wait();
    while (threads_.size() > workers) threads_.pop_back();
  }

  /// Ends all workers, for good.
  void stop() {
    cancel();
    threads_.clear();
  }

  std::vector<Phase> phases_;
  std::vector<double> spent_;
  Barrier do_frame_{1};
  std::vector<std::unique_ptr<Barrier>> phase_done_;
  Barrier frame_done_{1};
  std::vector<int> cores_ = usable_cores();
  std::shared_ptr<TimelineRecorder> recorder_;  // null: nothing is recorded
  std::vector<Thread> threads_;
  Failure failure_;
  Clock::duration frames_{0};             // where there are several workers
  std::atomic<Clock::rep> computing_{0};  // of all workers

  // Written by the control thread between frames or by finish(); the barriers order the rest.
  std::size_t count_ = 0;
  std::size_t current_ = 0;
  Clock::time_point phase_began_;
};

Crew::Crew(std::size_t workers, std::vector<Phase> phases)
    : implementation_(
          std::make_unique<Implementation>(std::max<std::size_t>(workers, 1), std::move(phases))) {}
Crew::~Crew() = default;

void Crew::do_frame(std::size_t first) {
  implementation_->do_frame(first);
}
void Crew::resize(std::size_t workers) {
  implementation_->resize(std::max<std::size_t>(workers, 1));
}
std::size_t Crew::workers() const {
  return implementation_->workers();
}
std::vector<BarrierStatus> Crew::barriers() const {
  return implementation_->barriers();
}
Crew::Effort Crew::effort() const {
  return implementation_->effort();
}
Seconds Crew::seconds() const {
  return implementation_->seconds();
}
void Crew::record_timeline(std::size_t frames) {
  implementation_->record_timeline(frames);
}
Timeline Crew::timeline(std::size_t frames) const {
  return implementation_->timeline(frames);
}

}  // namespace carom
