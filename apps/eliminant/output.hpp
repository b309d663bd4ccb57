/// \file
/// Where the result of a command goes: standard output, or a file that appears complete or not at all.
#pragma once

#include "eliminant/base/run.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace eliminant::app {

class OutputStream;

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

    /// For a result that is written in parts. \throws FileError
    OutputStream open(Run& run) const;

  private:
    std::string file_;   ///< as given; empty for standard output
    std::string target_; ///< where `file_` leads through symbolic links; empty if it is written in place
};

/// Takes a result in parts, as Destination::write takes it whole. What is not finished leaves the file as it
/// was; standard output, devices and pipes have then received a part of it.
class OutputStream {
  public:
    OutputStream(OutputStream&&) noexcept;
    ~OutputStream();

    /// \throws FileError, and Stopped if the run is interrupted meanwhile
    void write(std::string_view text);
    /// For a result whose parts come in another sequence than they have in the file, instead of write().
    /// Standard output, devices and pipes receive it at finish(); until then it is in a nameless file where
    /// temporary files go. \throws as write()
    void write_at(std::uint64_t offset, std::string_view text);
    /// After the last part: the file gets its name. \throws FileError, Stopped
    void finish();

  private:
    friend class Destination;
    class TemporaryFile;
    class Spool;
    OutputStream(std::string file, std::string target, Run& run);

    std::string file_;   ///< as in Destination
    std::string target_; ///< as in Destination
    Run* run_;
    int descriptor_ = -1;
    std::unique_ptr<TemporaryFile> temporary_; ///< if the file is replaced
    std::unique_ptr<Spool> spool_;             ///< of write_at() without one
};

} // namespace eliminant::app
