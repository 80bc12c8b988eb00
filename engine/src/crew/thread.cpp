#include "crew/thread.hpp"

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
  Attributes() {
    pthread_attr_init(&attributes_);
    pthread_attr_setstacksize(&attributes_, kStackBytes);
  }
  ~Attributes() { pthread_attr_destroy(&attributes_); }
  Attributes(const Attributes&) = delete;
  Attributes& operator=(const Attributes&) = delete;
  [[nodiscard]] const pthread_attr_t* get() const { return &attributes_; }

 private:
  pthread_attr_t attributes_{};
};

}  // namespace

Thread::Thread(std::function<void()> body)
    : body_(std::make_unique<std::function<void()>>(std::move(body))) {
  const Attributes attributes;
  const int error = pthread_create(&id_, attributes.get(), run_body, body_.get());
  if (error != 0) throw std::system_error(error, std::generic_category());
}

Thread::~Thread() {
  if (body_) pthread_join(id_, nullptr);
}

}  // namespace carom
