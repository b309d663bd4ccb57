/// \file
/// Where the result of a command goes: standard output, or a file that appears complete or not at all.
#pragma once

#include "eliminant/base/run.hpp"

#include <string>
#include <string_view>

namespace eliminant::app {

/// The place for results.
class Destination {
  public:
    /// Standard output for an empty name and for `-`, otherwise the file; nothing is created yet, but what
    /// can be known to fail fails now rather than after the computation. \throws FileError
    explicit Destination(std::string file);

    /// Writes the whole text, or throws and leaves the file as it was.
    ///
    /// A file is written under a temporary name in its directory, then renamed. An existing file keeps its
    /// permissions, and must be writable; a symbolic link stays one, and what it points at is replaced.
    /// Devices and pipes are written in place. \throws FileError, and Stopped if `run` is interrupted
    /// meanwhile
    void write(std::string_view text, Run& run) const;

  private:
    void replace_file(std::string_view text, Run& run) const;

    std::string file_;   ///< as given; empty for standard output
    std::string target_; ///< where `file_` leads through symbolic links; empty if it is written in place
};

} // namespace eliminant::app
