#pragma once

#include <string>
#include <vector>

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

namespace dirt::test {

/// A program that ends with this.
class Process {
public:
    explicit Process(const std::vector<std::string>& command, int output = -1) {
        id_ = fork();
        if (id_ != 0) return;
        if (output >= 0) dup2(output, 3);
        std::vector<char*> words;
        for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
        words.push_back(nullptr);
        execvp(words[0], words.data());
        _exit(127);
    }
    ~Process() {
        if (id_ > 0) kill(id_, SIGTERM), wait();
    }
    /// Its exit status.
    int wait() {
        int status = 0;
        waitpid(id_, &status, 0);
        id_ = 0;
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }

private:
    pid_t id_ = 0;
};

} // namespace dirt::test
