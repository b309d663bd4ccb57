#include "eliminant/base/error.hpp"

#include <utility>

namespace eliminant::base {

namespace {

std::string parse_message(const SourceLocation& where, std::string_view expected, std::string_view found) {
    std::string message = where.source;
    message.append(":").append(std::to_string(where.line));
    message.append(":").append(std::to_string(where.column));
    message.append(": expected ").append(expected).append(", found ").append(found);
    return message;
}

} // namespace

ParseError::ParseError(SourceLocation where, std::string expected, std::string found, std::string line_text)
    : Error(parse_message(where, expected, found)), where_(std::move(where)), expected_(std::move(expected)),
      found_(std::move(found)), line_text_(std::move(line_text)) {}

std::string_view to_string(StopReason reason) {
    switch (reason) {
    case StopReason::interrupted:
        return "interrupted";
    case StopReason::time_limit:
        return "time limit reached";
    case StopReason::memory_limit:
        return "memory limit reached";
    }
    return "stopped";
}

Stopped::Stopped(StopReason reason) : Error(std::string(to_string(reason))), reason_(reason) {}

} // namespace eliminant::base
