/// \file
/// Runs a program as a user would and captures what it says. For tests; POSIX.
#pragma once

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace eliminant::test {

/// What a program is started with.
struct ProcessOptions {
    std::string input = {};                                            ///< its standard input
    std::string directory = {};                                        ///< where it runs; here, if empty
    std::vector<std::pair<std::string, std::string>> environment = {}; ///< set in addition
    std::string output_file = {}; ///< opened for its standard output instead of a pipe
    bool closed_output = false;   ///< standard output is a pipe that nobody reads
    bool terminal = false;        ///< standard error is a terminal of 80 columns
    bool keep_input_open = false; ///< standard input does not end
    /// Sent once standard error or output has said `signal_after` (at once if that is empty), one after the
    /// other.
    std::vector<int> signals = {};
    std::string signal_after = {};
    std::chrono::milliseconds timeout{60000}; ///< then it is killed, and the run throws
};

/// What became of it.
struct ProcessResult {
    int status = -1;    ///< exit status, if it exited
    int killed_by = 0;  ///< signal that ended it, otherwise 0
    std::string output; ///< standard output
    std::string errors; ///< standard error
};

namespace detail {

struct Pipe {
    int read_end = -1;
    int write_end = -1;
    Pipe() {
        std::array<int, 2> ends{};
        if (pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("pipe2 failed");
        read_end = ends[0];
        write_end = ends[1];
    }
    ~Pipe() {
        close_read();
        close_write();
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;
    void close_read() { close_end(read_end); }
    void close_write() { close_end(write_end); }

  private:
    static void close_end(int& end) {
        if (end >= 0) close(std::exchange(end, -1));
    }
};

/// Gives a pipe the two ends of a pseudo-terminal.
inline void make_terminal(Pipe& pipe) {
    const int controller = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
    if (controller < 0 || grantpt(controller) != 0 || unlockpt(controller) != 0)
        throw std::runtime_error("no pseudo-terminal");
    const int terminal = open(ptsname(controller), O_RDWR | O_NOCTTY | O_CLOEXEC);
    winsize size{};
    size.ws_row = 24;
    size.ws_col = 80;
    if (terminal < 0 || ioctl(terminal, TIOCSWINSZ, &size) != 0)
        throw std::runtime_error("no pseudo-terminal");
    pipe.close_read();
    pipe.close_write();
    pipe.read_end = controller;
    pipe.write_end = terminal;
}

/// In the child: descriptors, directory, environment, program. Does not return.
[[noreturn]] inline void become(const std::vector<std::string>& command, const ProcessOptions& options,
                                int input, int output, int errors) {
    if (!options.output_file.empty())
        output = open(options.output_file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    dup2(input, STDIN_FILENO);
    dup2(output, STDOUT_FILENO);
    dup2(errors, STDERR_FILENO);
    signal(SIGPIPE, SIG_DFL);
    if (!options.directory.empty() && chdir(options.directory.c_str()) != 0) _exit(126);
    for (const auto& [name, value] : options.environment) setenv(name.c_str(), value.c_str(), 1);
    std::vector<char*> arguments;
    for (const std::string& argument : command) arguments.push_back(const_cast<char*>(argument.c_str()));
    arguments.push_back(nullptr);
    execv(arguments[0], arguments.data());
    _exit(127);
}

/// Moves bytes between us and the child until it has closed its outputs.
class Conversation {
  public:
    Conversation(pid_t child, const ProcessOptions& options, Pipe& input, Pipe& output, Pipe& errors)
        : child_(child), options_(options), input_(input), output_(output), errors_(errors) {}

    /// False if the time is up.
    bool hold(ProcessResult& result) {
        const auto deadline = std::chrono::steady_clock::now() + options_.timeout;
        signal_when_due(result);
        while (output_.read_end >= 0 || errors_.read_end >= 0) {
            const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(
                deadline - std::chrono::steady_clock::now());
            if (left.count() <= 0) return false;
            std::array<pollfd, 3> requests{{{output_.read_end, POLLIN, 0},
                                            {errors_.read_end, POLLIN, 0},
                                            {input_done_ ? -1 : input_.write_end, POLLOUT, 0}}};
            poll(requests.data(), requests.size(), static_cast<int>(left.count()));
            if (requests[0].revents != 0) receive(output_, result.output);
            if (requests[1].revents != 0) receive(errors_, result.errors);
            if (requests[2].revents != 0) send();
            signal_when_due(result);
        }
        return true;
    }

  private:
    static void receive(Pipe& pipe, std::string& text) {
        std::array<char, 1 << 16> buffer{};
        const ssize_t count = read(pipe.read_end, buffer.data(), buffer.size());
        if (count > 0)
            text.append(buffer.data(), static_cast<std::size_t>(count));
        else
            pipe.close_read(); // a terminal ends with EIO
    }

    void send() {
        const std::size_t left = options_.input.size() - sent_;
        const ssize_t count = left == 0 ? 0 : write(input_.write_end, options_.input.data() + sent_, left);
        if (count > 0) sent_ += static_cast<std::size_t>(count);
        if (count < 0 || sent_ == options_.input.size()) {
            input_done_ = true;
            if (!options_.keep_input_open || count < 0) input_.close_write();
        }
    }

    void signal_when_due(const ProcessResult& result) {
        if (signals_sent_ || (result.errors + result.output).find(options_.signal_after) == std::string::npos)
            return;
        signals_sent_ = true;
        for (const int number : options_.signals) {
            kill(child_, number);
            usleep(20000); // two equal signals that are pending together would be one
        }
    }

    pid_t child_;
    const ProcessOptions& options_;
    Pipe& input_;
    Pipe& output_;
    Pipe& errors_;
    std::size_t sent_ = 0;
    bool input_done_ = false;
    bool signals_sent_ = false;
};

} // namespace detail

/// Runs `command` (its first element is a path) to its end.
/// \throws std::runtime_error if it does not end in time
inline ProcessResult run_process(const std::vector<std::string>& command,
                                 const ProcessOptions& options = {}) {
    signal(SIGPIPE, SIG_IGN); // the child may not read all of its input
    detail::Pipe input;
    detail::Pipe output;
    detail::Pipe errors;
    if (options.terminal) detail::make_terminal(errors);

    if (options.closed_output) output.close_read(); // before there is somebody who could write
    const pid_t child = fork();
    if (child < 0) throw std::runtime_error("fork failed");
    if (child == 0) detail::become(command, options, input.read_end, output.write_end, errors.write_end);
    input.close_read();
    output.close_write();
    errors.close_write();
    fcntl(input.write_end, F_SETFL, O_NONBLOCK);

    ProcessResult result;
    const bool in_time = detail::Conversation(child, options, input, output, errors).hold(result);
    if (!in_time) kill(child, SIGKILL);
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    if (!in_time) throw std::runtime_error("not finished in time; it said: " + result.errors);
    if (WIFEXITED(status)) result.status = WEXITSTATUS(status);
    if (WIFSIGNALED(status)) result.killed_by = WTERMSIG(status);
    return result;
}

} // namespace eliminant::test
