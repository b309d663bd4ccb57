/// \file
/// The built program, and places to run it in.
#pragma once

#include "support/process.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace eliminant::test {

/// Runs the program with these arguments.
inline ProcessResult run(const std::vector<std::string>& arguments, const ProcessOptions& options = {}) {
    std::vector<std::string> command{ELIMINANT_PROGRAM};
    command.insert(command.end(), arguments.begin(), arguments.end());
    return run_process(command, options);
}

/// Runs the program with these arguments and this standard input.
inline ProcessResult run_with_input(const std::vector<std::string>& arguments, const std::string& input) {
    return run(arguments, {.input = input});
}

/// It succeeded, said nothing else, and printed this.
inline void expect_output(const ProcessResult& result, const std::string& output) {
    EXPECT_EQ(result.output, output);
    EXPECT_EQ(result.errors, "");
    EXPECT_EQ(result.status, 0);
}

/// It printed nothing, complained in one line, and that is this one.
inline void expect_error(const ProcessResult& result, int status, const std::string& message) {
    EXPECT_EQ(result.errors, "eliminant: " + message + "\n");
    EXPECT_EQ(result.output, "");
    EXPECT_EQ(result.status, status);
}

/// It printed nothing and complained in one line which contains this.
inline void expect_error_with(const ProcessResult& result, int status, const std::string& part) {
    EXPECT_NE(result.errors.find(part), std::string::npos) << "it said: " << result.errors;
    EXPECT_EQ(result.errors.rfind("eliminant: ", 0), 0U) << "it said: " << result.errors;
    EXPECT_EQ(result.errors.find('\n'), result.errors.size() - 1) << "it said: " << result.errors;
    EXPECT_EQ(result.output, "");
    EXPECT_EQ(result.status, status);
}

/// An empty directory that lives as long as this.
class ScratchDirectory {
  public:
    ScratchDirectory() {
        std::string name = (std::filesystem::temp_directory_path() / "eliminant-test-XXXXXX").string();
        if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary directory");
        path_ = name;
    }
    ~ScratchDirectory() {
        std::error_code ignored;
        std::filesystem::permissions(path_, std::filesystem::perms::owner_all, ignored);
        std::filesystem::remove_all(path_, ignored);
    }
    ScratchDirectory(const ScratchDirectory&) = delete;
    ScratchDirectory& operator=(const ScratchDirectory&) = delete;

    std::string path() const { return path_.string(); }
    std::string path(const std::string& name) const { return (path_ / name).string(); }
    std::string write(const std::string& name, const std::string& text) const {
        std::ofstream(path(name), std::ios::binary) << text;
        return path(name);
    }
    std::string read(const std::string& name) const {
        std::ifstream file(path(name), std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }
    /// Names of all that is in it, sorted.
    std::vector<std::string> names() const {
        std::vector<std::string> result;
        for (const auto& entry : std::filesystem::directory_iterator(path_))
            result.push_back(entry.path().filename().string());
        std::sort(result.begin(), result.end());
        return result;
    }

  private:
    std::filesystem::path path_;
};

/// A system whose basis takes hours.
inline const std::vector<std::string>& endless_system() {
    // The elementary cyclic sums of nine variables: cyclic-9.
    static const std::vector<std::string> polynomials = [] {
        const std::string names = "abcdefghi";
        std::vector<std::string> sums;
        for (std::size_t length = 1; length < names.size(); ++length) {
            std::string sum;
            for (std::size_t first = 0; first < names.size(); ++first) {
                if (first != 0) sum += '+';
                for (std::size_t i = 0; i < length; ++i) {
                    if (i != 0) sum += '*';
                    sum += names[(first + i) % names.size()];
                }
            }
            sums.push_back(std::move(sum));
        }
        sums.emplace_back("a*b*c*d*e*f*g*h*i-1");
        return sums;
    }();
    return polynomials;
}

} // namespace eliminant::test
