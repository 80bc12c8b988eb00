#pragma once

#include "options.hpp"

namespace carom {

/// Each runs one command of the program and gives its exit status: 0 done, 1 it failed while
/// running, 2 wrong usage or a bad scene (thrown as SceneError or UsageError, said by main).
int play(const Options& options);
int run(const Options& options);
int accuracy(const Options& options);
int check(const Options& options);
int verify(const Options& options);
int sweep(const Options& options);
int scenes(const Options& options);

}  // namespace carom
