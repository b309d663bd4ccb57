// Where results go: -o, standard output, and what is left behind when writing fails.
#include "program.hpp"

#include <sys/stat.h>

namespace eliminant::test {
namespace {

namespace fs = std::filesystem;

TEST(Output, IsWrittenToAFile) {
    const ScratchDirectory scratch;
    expect_output(run({"groebner", "x^2-1", "-o", scratch.path("basis")}), "");
    EXPECT_EQ(scratch.read("basis"), "x^2-1\n");
    expect_output(run({"groebner", "x", "-o" + scratch.path("basis")}), "");
    EXPECT_EQ(scratch.read("basis"), "x\n");
    EXPECT_EQ(scratch.names(), std::vector<std::string>{"basis"});
    expect_output(run({"groebner", "x", "--output", "here"}, {.directory = scratch.path()}), "");
    EXPECT_EQ(scratch.read("here"), "x\n");
    expect_output(run({"groebner", "x", "-o", "-"}), "x\n");
}

TEST(Output, KeepsThePermissionsOfAFileAndHonoursTheUmask) {
    const ScratchDirectory scratch;
    const std::string file = scratch.write("basis", "old\n");
    ASSERT_EQ(chmod(file.c_str(), 0640), 0);
    expect_output(run({"groebner", "x", "-o", file}), "");
    struct stat status {};
    ASSERT_EQ(stat(file.c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 07777, 0640U);

    const mode_t before = umask(027);
    expect_output(run({"groebner", "x", "-o", scratch.path("new")}), "");
    umask(before);
    ASSERT_EQ(stat(scratch.path("new").c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 07777, 0640U);
}

TEST(Output, FollowsSymbolicLinks) {
    const ScratchDirectory scratch;
    fs::create_directory(scratch.path("elsewhere"));
    scratch.write("elsewhere/target", "old\n");
    fs::create_symlink("elsewhere/target", scratch.path("link"));
    fs::create_symlink("elsewhere/new", scratch.path("dangling"));
    expect_output(run({"groebner", "x", "-o", scratch.path("link")}), "");
    expect_output(run({"groebner", "y", "-o", scratch.path("dangling")}), "");
    EXPECT_TRUE(fs::is_symlink(scratch.path("link")));
    EXPECT_TRUE(fs::is_symlink(scratch.path("dangling")));
    EXPECT_EQ(scratch.read("elsewhere/target"), "x\n");
    EXPECT_EQ(scratch.read("elsewhere/new"), "y\n");

    fs::create_symlink("loop", scratch.path("loop"));
    expect_error_with(run({"groebner", "x", "-o", scratch.path("loop")}), 2,
                      "too many levels of symbolic links");
}

TEST(Output, NamesWhatCannotBeWritten) {
    const ScratchDirectory scratch;
    expect_error(run({"groebner", "x", "-o", scratch.path()}), 2, scratch.path() + ": is a directory");
    expect_error(run({"groebner", "x", "-o", scratch.path("no/basis")}), 2,
                 scratch.path("no/basis") + ": no such directory '" + scratch.path("no") + "'");
    const std::string file = scratch.write("file", "old\n");
    expect_error_with(run({"groebner", "x", "-o", file + "/basis"}), 2, file + "/basis: ");
    expect_error(run({"groebner", "x", "-o", ""}), 2, "--output: expected the name of a file, found ''");
}

TEST(Output, RespectsWriteProtection) {
    if (geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
    const ScratchDirectory scratch;
    const std::string file = scratch.write("basis", "old\n");
    ASSERT_EQ(chmod(file.c_str(), 0440), 0);
    expect_error(run({"groebner", "x", "-o", file}), 2, file + ": permission denied");
    EXPECT_EQ(scratch.read("basis"), "old\n");
    ASSERT_EQ(chmod(scratch.path().c_str(), 0550), 0);
    expect_error(run({"groebner", "x", "-o", scratch.path("new")}), 2,
                 scratch.path("new") + ": no permission to create files in directory '" + scratch.path() +
                     "'");
}

TEST(Output, AFileStaysAsItWasOnEveryFailure) {
    const ScratchDirectory scratch;
    const std::string file = scratch.write("basis", "old\n");
    const auto expect_old = [&] {
        EXPECT_EQ(scratch.read("basis"), "old\n");
        EXPECT_EQ(scratch.names(), std::vector<std::string>{"basis"});
    };
    EXPECT_EQ(run({"groebner", "x +", "-o", file}).status, 2);
    expect_old();
    std::vector<std::string> endless{"groebner", "-o", file, "--time-limit", "0.05"};
    endless.insert(endless.end(), endless_system().begin(), endless_system().end());
    EXPECT_EQ(run(endless).status, 3);
    expect_old();
    // The shell lets no file grow beyond one block, which is what a full disk does.
    const std::string big = scratch.write("big.sys", "(x+y+z+t+1)^9\n");
    const ProcessResult result =
        run_process({"/bin/sh", "-c", "trap '' XFSZ; ulimit -f 1; exec \"$0\" groebner big.sys -o basis",
                     ELIMINANT_PROGRAM},
                    {.directory = scratch.path()});
    expect_error(result, 2, "basis: file too large");
    fs::remove(big);
    expect_old();
}

TEST(Output, DevicesAreWrittenInPlace) {
    expect_output(run({"groebner", "x", "-o", "/dev/stdout"}), "x\n");
    expect_output(run({"groebner", "x", "-o", "/dev/null"}), "");
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
    expect_error(run({"groebner", "x", "-o", "/dev/full"}), 2, "/dev/full: no space left on device");
}

TEST(Output, FailingStandardOutputIsAnError) {
    expect_error(run({"groebner", "x"}, {.output_file = "/dev/full"}), 2,
                 "standard output: no space left on device");
    expect_error(run({"groebner", "x"}, {.closed_output = true}), 2, "standard output: broken pipe");
    expect_error(run({"--help"}, {.closed_output = true}), 2, "standard output: broken pipe");
    const ProcessResult closed =
        run_process({"/bin/sh", "-c", "exec \"$0\" groebner x >&-", ELIMINANT_PROGRAM});
    expect_error(closed, 2, "standard output: bad file descriptor");
}

} // namespace
} // namespace eliminant::test
