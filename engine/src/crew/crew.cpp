#include "carom/crew.hpp"

#include <chrono>
#include <exception>
#include <mutex>
#include <thread>

#include "carom/barrier.hpp"

namespace carom {

using Clock = std::chrono::steady_clock;

class Crew::Implementation {
 public:
  Implementation(std::size_t workers, std::vector<Phase> phases)
      : phases_(std::move(phases)), spent_(phases_.size(), 0.0) {
    resize(workers);
  }
  ~Implementation() { stop(); }

  void do_frame(std::size_t first) {
    current_ = first;
    started_ = Clock::now();
    (void)do_frame_->arrive_and_wait();
    (void)frame_done_->arrive_and_wait();
    if (failure_) std::rethrow_exception(failure_);
  }

  void resize(std::size_t workers) {
    stop();
    quit_ = false;
    do_frame_ = std::make_unique<Barrier>(workers + 1);
    frame_done_ = std::make_unique<Barrier>(workers + 1);
    barriers_.clear();
    for (std::size_t i = 0; i < phases_.size(); ++i) {
      barriers_.push_back(std::make_unique<Barrier>(workers, [this, i] { finish(i); }));
    }
    for (std::size_t i = 0; i < workers; ++i) {
      threads_.emplace_back([this, i, workers] { live(Share{i, workers}); });
    }
  }

  std::size_t workers() const { return threads_.size(); }
  Seconds seconds() const {
    Seconds result;
    for (std::size_t i = 0; i < phases_.size(); ++i)
      result.emplace_back(phases_[i].name, spent_[i]);
    return result;
  }

 private:
  void live(Share share) {
    while (do_frame_->arrive_and_wait() && !quit_) {
      try {
        while (current_ != Phase::kFrameDone) {
          const std::size_t now = current_;
          phases_[now].work(share);
          if (!barriers_[now]->arrive_and_wait()) return;
        }
      } catch (...) {
        fail(std::current_exception());
        return;
      }
      if (!frame_done_->arrive_and_wait()) return;
    }
  }
  void finish(std::size_t phase) {
    const auto now = Clock::now();
    spent_[phase] += std::chrono::duration<double>(now - started_).count();
    started_ = now;
    current_ = phases_[phase].finish();
  }
  void fail(std::exception_ptr failure) {
    const std::scoped_lock lock(mutex_);
    if (!failure_) failure_ = std::move(failure);
    do_frame_->cancel();
    frame_done_->cancel();
    for (auto& barrier : barriers_) barrier->cancel();
  }
  void stop() {
    if (threads_.empty()) return;
    quit_ = true;
    (void)do_frame_->arrive_and_wait();
    for (auto& thread : threads_) thread.join();
    threads_.clear();
  }

  std::vector<Phase> phases_;
  std::vector<double> spent_;
  std::unique_ptr<Barrier> do_frame_;
  std::unique_ptr<Barrier> frame_done_;
  std::vector<std::unique_ptr<Barrier>> barriers_;
  std::vector<std::thread> threads_;
  std::size_t current_ = 0;
  Clock::time_point started_;
  bool quit_ = false;
  std::mutex mutex_;
  std::exception_ptr failure_;
};

Crew::Crew(std::size_t workers, std::vector<Phase> phases)
    : implementation_(std::make_unique<Implementation>(workers, std::move(phases))) {}
Crew::~Crew() = default;
void Crew::do_frame(std::size_t first) {
  implementation_->do_frame(first);
}
void Crew::resize(std::size_t workers) {
  implementation_->resize(workers);
}
std::size_t Crew::workers() const {
  return implementation_->workers();
}
Seconds Crew::seconds() const {
  return implementation_->seconds();
}

}  // namespace carom
