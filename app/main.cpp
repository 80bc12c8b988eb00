#include <cstdio>
#include <exception>

#include "carom/scene_file.hpp"
#include "commands.hpp"

int main(int argc, char** argv) {
  try {
    carom::Options options;
    if (argc > 2) options.scenes.emplace_back(argv[2]);
    return carom::run(options);
  } catch (const carom::SceneError& error) {
    std::fprintf(stderr, "carom: %s\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "carom: %s\n", error.what());
    return 1;
  }
}
