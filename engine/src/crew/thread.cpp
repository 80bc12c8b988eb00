#include "crew/thread.hpp"

#include <sched.h>

#include <cerrno>
#include <cstddef>
#include <system_error>
#include <utility>

namespace carom {
namespace {

// What the system needs for itself (some 20 KiB where vector registers are wide) and room for the
// phases, which keep their data elsewhere.  Only pages that are touched take memory.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr std::size_t kStackBytes = 512UL * 1024;
#else
constexpr std::size_t kStackBytes = 128UL * 1024;
#endif

extern "C" void* run_body(void* body) {
  (*static_cast<std::function<void()>*>(body))();
  return nullptr;
}

class Attributes {
 public:
  explicit Attributes(std::optional<int> core) {
    pthread_attr_init(&attributes_);
    pthread_attr_setstacksize(&attributes_, kStackBytes);
    if (core) {
      cpu_set_t only;
      CPU_ZERO(&only);
      CPU_SET(*core, &only);
      pthread_attr_setaffinity_np(&attributes_, sizeof only, &only);
    }
  }
  ~Attributes() { pthread_attr_destroy(&attributes_); }
  Attributes(const Attributes&) = delete;
  Attributes& operator=(const Attributes&) = delete;
  [[nodiscard]] const pthread_attr_t* get() const { return &attributes_; }

 private:
  pthread_attr_t attributes_{};
};

}  // namespace

Thread::Thread(std::function<void()> body, std::optional<int> core)
    : body_(std::make_unique<std::function<void()>>(std::move(body))) {
  const auto create = [this](std::optional<int> where) {
    return pthread_create(&id_, Attributes(where).get(), run_body, body_.get());
  };
  int error = create(core);
  if (error == EINVAL && core) error = create({});  // the core was taken away meanwhile
  if (error != 0) throw std::system_error(error, std::generic_category());
}

Thread::~Thread() {
  if (body_) pthread_join(id_, nullptr);
}

std::vector<int> usable_cores() {
  std::vector<int> cores;
  cpu_set_t usable;
  CPU_ZERO(&usable);
  if (sched_getaffinity(0, sizeof usable, &usable) != 0) return cores;
  for (int core = 0; core < CPU_SETSIZE; ++core) {
    if (CPU_ISSET(core, &usable)) cores.push_back(core);
  }
  return cores;
}

}  // namespace carom
