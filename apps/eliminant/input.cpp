#include "input.hpp"

#include "option_set.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

namespace eliminant::app {

namespace {

class FileDescriptor {
  public:
    explicit FileDescriptor(int descriptor) : descriptor_(descriptor) {}
    ~FileDescriptor() { close(descriptor_); }
    FileDescriptor(const FileDescriptor&) = delete;
    FileDescriptor& operator=(const FileDescriptor&) = delete;
    int get() const { return descriptor_; }

  private:
    int descriptor_;
};

std::string lower_case_first(std::string text) {
    if (!text.empty()) text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
    return text;
}

std::string in_words(int error_number) {
    return error_number == ENOENT ? "no such file" : lower_case_first(std::strerror(error_number));
}

/// Everything until the end of file. A terminal or pipe may keep us waiting for ever, so we ask before we
/// read: a signal or limit is noticed within 20 ms.
std::string read_all(int descriptor, const std::string& name, Run& run) {
    constexpr int patience_milliseconds = 20;
    std::string text;
    std::array<char, 1 << 16> buffer{};
    for (;;) {
        run.poll();
        pollfd request{descriptor, POLLIN, 0};
        const int ready = poll(&request, 1, patience_milliseconds);
        if (ready == 0 || (ready < 0 && errno == EINTR)) continue;
        const ssize_t count = read(descriptor, buffer.data(), buffer.size());
        if (count == 0) return text;
        if (count > 0)
            text.append(buffer.data(), static_cast<std::size_t>(count));
        else if (errno != EINTR && errno != EAGAIN)
            throw FileError(name, errno);
    }
}

Input read_file(const std::string& path, Run& run) {
    // Blocking, the opening of a named pipe that nobody writes to would be beyond the reach of limits.
    const FileDescriptor file(open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
    if (file.get() < 0) throw FileError(path, errno);
    return {false, {{path, read_all(file.get(), path, run)}}};
}

Input read_standard_input(Run& run) { return {false, {{"-", read_all(STDIN_FILENO, "-", run)}}}; }

/// The error number of a file that is no use as input; 0 for one that can be opened.
int file_problem(const std::string& path) {
    struct stat status {};
    if (stat(path.c_str(), &status) != 0) return errno;
    return S_ISDIR(status.st_mode) ? EISDIR : 0;
}

/// Whether a name ends in a dot and an extension that begins with a letter.
bool has_extension(std::string_view name) {
    const std::size_t dot = name.rfind('.');
    if (dot == std::string_view::npos || dot == 0 || dot + 1 == name.size()) return false;
    const std::string_view extension = name.substr(dot + 1);
    return std::isalpha(static_cast<unsigned char>(extension[0])) != 0 &&
           std::all_of(extension.begin(), extension.end(),
                       [](unsigned char c) { return std::isalnum(c) != 0; });
}

/// Whether a slash leads to a name: `dir/name`, `/name`, but neither `x/2` nor `1/(2)`, nor `x/y`, a quotient
/// of single letters.
bool is_path(std::string_view argument) {
    if (argument.starts_with("./") || argument.starts_with("../")) return true;
    const std::size_t slash = argument.find('/');
    if (slash == std::string_view::npos || slash + 1 == argument.size()) return false;
    return std::isalpha(static_cast<unsigned char>(argument[slash + 1])) != 0 &&
           (slash != 1 || argument.size() > 3);
}

} // namespace

FileError::FileError(std::string_view file, std::string_view what)
    : Error((file == "-" ? std::string("standard input") : std::string(file)) + ": " + std::string(what)) {}

FileError::FileError(std::string_view file, int error_number) : FileError(file, in_words(error_number)) {}

bool looks_like_polynomial(std::string_view argument) {
    if (argument.find_first_of("=^*+()\n") != std::string_view::npos) return true;
    return !has_extension(argument) && !is_path(argument);
}

bool looks_like_equation(std::string_view argument) {
    const std::string_view first_word = argument.substr(0, argument.find_first_of(" \t"));
    return argument.find_first_of("=^*+(\n") != std::string_view::npos || first_word == "parameters" ||
           first_word == "constants" || first_word == "relation";
}

Input input_of(std::span<const std::string> operands,
               const std::function<bool(std::string_view)>& is_expression, Run& run) {
    if (operands.empty()) {
        if (isatty(STDIN_FILENO) == 1)
            throw UsageError("input: expected a file, '-' or expressions, found the end of the command line");
        return read_standard_input(run);
    }
    if (operands.size() == 1 && operands.front() == "-") return read_standard_input(run);

    Input input{true, {}};
    for (const std::string& operand : operands) {
        const int problem = file_problem(operand);
        if (operands.size() == 1 && problem == 0) return read_file(operand, run);
        if (!is_expression(operand) || operand == "-") {
            if (problem != 0 && operand != "-") throw FileError(operand, problem);
            throw UsageError("input: expected one file or several expressions, found '" + operand +
                             "' among several arguments");
        }
        std::string name = "argument";
        if (operands.size() > 1) name.append(" ").append(std::to_string(input.parts.size() + 1));
        input.parts.push_back({std::move(name), operand});
    }
    return input;
}

} // namespace eliminant::app
