// Two threads hand a plain number to and fro; only the barrier orders what they do.
#include <carom/barrier.hpp>
#include <cstdio>
#include <thread>

int main() {
  carom::Barrier barrier(2);
  int number = 0;
  const auto work = [&](int me) {
    for (int turn = 0; turn < 1000; ++turn) {
      if (turn % 2 == me) ++number;
      if (!barrier.arrive_and_wait()) return;
    }
  };
  std::thread other(work, 1);
  work(0);
  other.join();
  std::printf("%d\n", number);
}
