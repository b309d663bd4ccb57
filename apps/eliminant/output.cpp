#include "output.hpp"

#include "input.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace eliminant::app {

namespace {

namespace fs = std::filesystem;

/// A failing destination in words: `standard output: no space left on device`.
FileError write_error(const std::string& file, int error_number) {
    return {file.empty() ? "standard output" : file, error_number};
}

void write_blocks(int descriptor, std::string_view text, const std::string& file, Run& run) {
    constexpr std::size_t block = 1 << 20;
    while (!text.empty()) {
        // A limit that passes now does not take back what was found in time.
        if (run.stop_reason() == StopReason::interrupted) run.poll();
        const ssize_t written = ::write(descriptor, text.data(), std::min(text.size(), block));
        if (written >= 0)
            text.remove_prefix(static_cast<std::size_t>(written));
        else if (errno != EINTR)
            throw write_error(file, errno);
    }
}

void write_blocks_at(int descriptor, std::string_view text, std::uint64_t offset, const std::string& file,
                     Run& run) {
    while (!text.empty()) {
        if (run.stop_reason() == StopReason::interrupted) run.poll();
        const ssize_t written = pwrite(descriptor, text.data(), text.size(), static_cast<off_t>(offset));
        if (written >= 0) {
            text.remove_prefix(static_cast<std::size_t>(written));
            offset += static_cast<std::uint64_t>(written);
        } else if (errno != EINTR) {
            throw write_error(file, errno);
        }
    }
}

/// Opens a device or a pipe, which may have to wait for its reader.
int open_in_place(const std::string& file, Run& run) {
    for (;;) {
        const int descriptor = open(file.c_str(), O_WRONLY | O_CLOEXEC);
        if (descriptor >= 0) return descriptor;
        if (errno != EINTR) throw FileError(file, errno);
        run.poll();
    }
}

std::optional<mode_t> mode_of(const std::string& path) {
    struct stat status {};
    if (stat(path.c_str(), &status) != 0) return std::nullopt;
    return status.st_mode;
}

/// Follows symbolic links, also one that points at nothing yet. Links of /proc (as /dev/stdout leads to) are
/// open files rather than names: then the result is empty.
std::string behind_links(const std::string& file) {
    constexpr int most_links = 40; // as Linux has it
    fs::path path = file;
    for (int links = 0; links < most_links; ++links) {
        std::error_code error;
        if (!fs::is_symlink(path, error)) return path.string();
        if (path.string().starts_with("/proc/")) return {};
        const fs::path next = fs::read_symlink(path, error);
        if (error) throw FileError(file, error.value());
        path = next.is_absolute() ? next : path.parent_path() / next;
    }
    throw FileError(file, ELOOP);
}

} // namespace

Destination::Destination(std::string file) : file_(file == "-" ? std::string() : std::move(file)) {
    if (file_.empty()) return;
    const std::optional<mode_t> mode = mode_of(file_);
    if (mode && S_ISDIR(*mode)) throw FileError(file_, EISDIR);
    if (mode && access(file_.c_str(), W_OK) != 0) throw FileError(file_, errno);
    if (mode && !S_ISREG(*mode)) return;

    target_ = behind_links(file_);
    if (target_.empty()) return;
    const fs::path parent = fs::path(target_).parent_path();
    const std::string directory = parent.empty() ? "." : parent.string();
    const std::optional<mode_t> directory_mode = mode_of(directory);
    if (!directory_mode) throw FileError(file_, "no such directory '" + directory + "'");
    if (!S_ISDIR(*directory_mode)) throw FileError(file_, "'" + directory + "' is not a directory");
    if (access(directory.c_str(), W_OK | X_OK) != 0)
        throw FileError(file_, "no permission to create files in directory '" + directory + "'");
}

void Destination::write(std::string_view text, Run& run) const {
    OutputStream stream = open(run);
    stream.write(text);
    stream.finish();
}

OutputStream Destination::open(Run& run) const { return {file_, target_, run}; }

/// A new file beside its final place, which vanishes again unless it is moved there.
class OutputStream::TemporaryFile {
  public:
    explicit TemporaryFile(const std::string& target) {
        constexpr mode_t every_mode_the_umask_allows = 0666;
        for (unsigned attempt = 0; descriptor_ < 0; ++attempt) {
            path_ = target + ".partial-" + std::to_string(getpid()) + "-" + std::to_string(attempt);
            descriptor_ =
                open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, every_mode_the_umask_allows);
            if (descriptor_ < 0 && errno != EEXIST) throw FileError(target, errno);
        }
    }
    ~TemporaryFile() {
        if (descriptor_ >= 0) close(descriptor_);
        if (!path_.empty()) unlink(path_.c_str());
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    int descriptor() const { return descriptor_; }

    /// Some file systems report a full disk only when the file is synchronised or closed.
    void move_to(const std::string& target) {
        const bool synced = fsync(descriptor_) == 0;
        const int sync_error = errno;
        const bool closed = close(std::exchange(descriptor_, -1)) == 0;
        if (!synced && sync_error != EINVAL) throw FileError(target, sync_error);
        if (!closed || rename(path_.c_str(), target.c_str()) != 0) throw FileError(target, errno);
        path_.clear();
    }

  private:
    std::string path_;
    int descriptor_ = -1;
};

/// A nameless temporary file.
class OutputStream::Spool {
  public:
    Spool() : file_(std::tmpfile()) {
        if (file_ == nullptr) throw FileError("a temporary file", errno);
    }
    ~Spool() { std::fclose(file_); }
    Spool(const Spool&) = delete;
    Spool& operator=(const Spool&) = delete;

    void write_at(std::uint64_t offset, std::string_view text, Run& run) {
        write_blocks_at(fileno(file_), text, offset, "a temporary file", run);
    }
    void copy_to(int descriptor, const std::string& file, Run& run) const {
        constexpr std::size_t block = 1 << 20;
        std::string text(block, '\0');
        for (std::uint64_t offset = 0;;) {
            const ssize_t count = pread(fileno(file_), text.data(), block, static_cast<off_t>(offset));
            if (count < 0 && errno == EINTR) continue;
            if (count < 0) throw FileError("a temporary file", errno);
            if (count == 0) return;
            offset += static_cast<std::uint64_t>(count);
            write_blocks(descriptor, std::string_view(text).substr(0, static_cast<std::size_t>(count)), file,
                         run);
        }
    }

  private:
    std::FILE* file_;
};

OutputStream::OutputStream(std::string file, std::string target, Run& run)
    : file_(std::move(file)), target_(std::move(target)), run_(&run) {
    if (file_.empty()) {
        descriptor_ = STDOUT_FILENO;
    } else if (!target_.empty()) {
        temporary_ = std::make_unique<TemporaryFile>(target_);
        descriptor_ = temporary_->descriptor();
    } else {
        descriptor_ = open_in_place(file_, run);
    }
}

OutputStream::OutputStream(OutputStream&& other) noexcept
    : file_(std::move(other.file_)), target_(std::move(other.target_)), run_(other.run_),
      descriptor_(std::exchange(other.descriptor_, -1)), temporary_(std::move(other.temporary_)),
      spool_(std::move(other.spool_)) {}

OutputStream::~OutputStream() {
    if (descriptor_ >= 0 && descriptor_ != STDOUT_FILENO && !temporary_) close(descriptor_);
}

void OutputStream::write(std::string_view text) { write_blocks(descriptor_, text, file_, *run_); }

void OutputStream::write_at(std::uint64_t offset, std::string_view text) {
    if (temporary_) return write_blocks_at(descriptor_, text, offset, file_, *run_);
    if (!spool_) spool_ = std::make_unique<Spool>();
    spool_->write_at(offset, text, *run_);
}

void OutputStream::finish() {
    if (spool_) spool_->copy_to(descriptor_, file_, *run_);
    const int descriptor = std::exchange(descriptor_, -1);
    if (temporary_) {
        if (const std::optional<mode_t> mode = mode_of(target_))
            if (fchmod(descriptor, *mode & 07777) != 0) throw FileError(file_, errno);
        temporary_->move_to(target_);
    } else if (close(descriptor) != 0) { // a network file system may tell only now that it is full
        throw write_error(file_, errno);
    }
}

} // namespace eliminant::app
