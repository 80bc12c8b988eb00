#include "bits/outcome.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <stdexcept>
#include <utility>

#include "carom/scene_file.hpp"
#include "carom/session.hpp"

namespace carom::bits {
namespace {

std::string run(const std::filesystem::path& file, Method method, double seconds) {
  Scene scene = read_scene(file);
  scene.solver.method = method;
  if (method == Method::overlap) scene.solver.digits = 16;
  scene.workers = 1;
  scene.per_ball = false;
  try {
    Session session(std::move(scene));
    session.advance_clock_to(session.clock() + seconds);
    return session.simulation().state_hash();
  } catch (const SceneError&) {
    return "refused";
  } catch (const std::runtime_error&) {
    return "failed";
  }
}

}  // namespace

std::string outcome(const std::filesystem::path& file, Method method, double seconds) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) throw std::runtime_error("no pipe");
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("no process");
  if (child == 0) {
    const std::string text = run(file, method, seconds);
    const bool whole =
        write(ends[1], text.data(), text.size()) == static_cast<ssize_t>(text.size());
    _exit(whole ? 0 : 1);
  }
  close(ends[1]);
  std::array<char, 64> buffer{};
  const ssize_t length = read(ends[0], buffer.data(), buffer.size());
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  if (status != 0 || length <= 0) return "crashed";
  return {buffer.data(), static_cast<std::size_t>(length)};
}

}  // namespace carom::bits
