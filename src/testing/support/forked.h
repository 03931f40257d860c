#ifndef ARGOS3_TESTING_SUPPORT_FORKED_H
#define ARGOS3_TESTING_SUPPORT_FORKED_H

#include <sys/wait.h>
#include <unistd.h>

#include <exception>
#include <functional>
#include <iostream>

namespace argos {

/**
 * Calls a function in a child process that is made by fork(), and ends it after 20 s.
 * @return what the function returns in the child, 0 to 255; 254 if it throws, 255 if a signal ends
 *   the child: SIGALRM if it hangs.
 */
inline int CallInFork(const std::function<int()>& function) {
  const pid_t child = fork();
  if (child == 0) {
    alarm(20);
    int result = 254;
    try {
      result = function();
    } catch (const std::exception& error) {
      std::cerr << error.what() << std::endl;
    }
    _exit(result);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 255;
}

}  // namespace argos

#endif
