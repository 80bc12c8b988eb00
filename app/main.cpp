#include <exception>
#include <new>
#include <string>
#include <vector>

#include "carom/scene_file.hpp"
#include "commands.hpp"
#include "commit.hpp"
#include "options.hpp"
#include "standard_streams.hpp"

namespace {

int obey(const carom::Options& options) {
  switch (options.command) {
    case carom::Options::Command::play:
      return carom::play(options);
    case carom::Options::Command::run:
      return carom::run(options);
    case carom::Options::Command::accuracy:
      return carom::accuracy(options);
    case carom::Options::Command::check:
      return carom::check(options);
    case carom::Options::Command::verify:
      return carom::verify(options);
    case carom::Options::Command::sweep:
      return carom::sweep(options);
    case carom::Options::Command::scenes:
      return carom::scenes(options);
    case carom::Options::Command::help:
    case carom::Options::Command::print:
      carom::print(options.text);
      return 0;
  }
  return 0;
}

int say(const std::exception& error, int status) {
  carom::print_error_line(error.what());
  return status;
}

}  // namespace

int main(int argc, char** argv) {
  carom::hold_standard_streams();
  try {
    return obey(
        carom::parse_options(std::vector<std::string>(argv + 1, argv + argc), carom::commit()));
  } catch (const carom::UsageError& error) {
    return say(error, 2);
  } catch (const carom::SceneError& error) {
    return say(error, 2);
  } catch (const std::bad_alloc&) {
    carom::print_error_line("not enough memory: make the scene smaller, or allow the program more");
    return 1;
  } catch (const std::exception& error) {
    return say(error, 1);
  }
}
