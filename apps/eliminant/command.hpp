/// \file
/// What a subcommand is; the list of them.
#pragma once

#include "option_set.hpp"
#include "session.hpp"

#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace eliminant::app {

/// A subcommand: it declares its options, then runs once. What it prints goes through the Session; errors are
/// thrown.
class Command {
  public:
    virtual ~Command() = default;
    virtual std::string_view usage() const = 0;       ///< the operands, as in `[FILE | - | POLY …]`
    virtual std::string_view description() const = 0; ///< for `--help`: what it does, with examples
    virtual void declare(OptionSet& options) = 0;
    /// \returns the exit status
    virtual ExitStatus run(std::span<const std::string> operands, Session& session) = 0;
};

struct CommandEntry {
    std::string_view name;
    std::string_view summary;
    std::unique_ptr<Command> (*make)();
};

std::unique_ptr<Command> make_implicitize();
std::unique_ptr<Command> make_verify();
std::unique_ptr<Command> make_contains_point();
std::unique_ptr<Command> make_preimages();
std::unique_ptr<Command> make_inversion();
std::unique_ptr<Command> make_groebner();
std::unique_ptr<Command> make_divide();
std::unique_ptr<Command> make_eliminate();
std::unique_ptr<Command> make_ideal();
std::unique_ptr<Command> make_render();
std::unique_ptr<Command> make_distance();

} // namespace eliminant::app
