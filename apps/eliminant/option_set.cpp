#include "option_set.hpp"

#include "suggestion.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cctype>

namespace eliminant::app {

namespace {

std::string expected_found(std::string_view subject, std::string_view expected, std::string_view found) {
    std::string message(subject);
    message.append(": expected ").append(expected).append(", found ").append(found);
    return message;
}

/// Put before operands that CLI11 would take for options; no argument of a sane shell begins with it.
constexpr std::string_view protection = "\x01";

std::string_view unprotected(std::string_view argument) {
    return argument.starts_with(protection) ? argument.substr(protection.size()) : argument;
}

/// In CLI11's notation, `-o,--output`.
std::string names(std::string_view name, char short_name) {
    std::string text;
    if (short_name != 0) text.append("-").append(1, short_name).append(",");
    return text.append("--").append(name);
}

/// Calls the setter so that its complaint names the option.
template <class Set>
void set_option(std::string_view shown, const Set& set, std::string_view value) {
    try {
        set(value);
    } catch (const ParseError&) { // it names the option as its source, and the place in it
        throw;
    } catch (const Error& error) {
        const std::string message = error.what();
        const std::string subject = std::string(shown) + ": ";
        throw UsageError(message.starts_with(subject) ? message : subject + message);
    }
}

} // namespace

UsageError::UsageError(std::string_view subject, std::string_view expected, std::string_view found)
    : Error(expected_found(subject, expected, found)) {}

struct OptionSet::Parser : CLI::App {};

OptionSet::OptionSet() : app_(std::make_unique<Parser>()) {
    constexpr std::size_t explanation_column = 30;
    app_->set_help_flag();
    app_->get_formatter()->column_width(explanation_column);
}

OptionSet::~OptionSet() = default;

void OptionSet::flag(std::string_view name, char short_name, std::string_view help, bool& target) {
    app_->add_flag(names(name, short_name), target, std::string(help))
        ->disable_flag_override()
        ->group(heading_);
}

void OptionSet::value(std::string_view name, char short_name, std::string argument, std::string_view help,
                      Setter set) {
    std::string shown("--");
    shown += name;
    app_->add_option_function<std::string>(
            names(name, short_name),
            [shown = std::move(shown), set = std::move(set)](const std::string& text) {
                set_option(shown, set, unprotected(text));
            },
            std::string(help))
        ->take_last()
        ->type_name(std::move(argument))
        ->group(heading_);
}

void OptionSet::values(std::string_view name, std::string argument, std::string_view help, Setter set) {
    std::string shown("--");
    shown += name;
    app_->add_option_function<std::vector<std::string>>(
            names(name, 0),
            [shown = std::move(shown), set = std::move(set)](const std::vector<std::string>& texts) {
                for (const std::string& text : texts) set_option(shown, set, unprotected(text));
            },
            std::string(help))
        ->allow_extra_args(false)
        ->type_name(std::move(argument))
        ->group(heading_);
}

std::string OptionSet::joined(std::span<const std::string_view> words) {
    std::string text;
    for (const std::string_view word : words) {
        if (!text.empty()) text += '|';
        text += word;
    }
    return text;
}

std::size_t OptionSet::index_of(std::string_view found, std::span<const std::string_view> words) {
    const auto position = std::find(words.begin(), words.end(), found);
    if (position == words.end())
        throw Error("expected " + either(words) + ", found '" + std::string(found) + "'" +
                    did_you_mean(found, words));
    return static_cast<std::size_t>(position - words.begin());
}

/// An argument that begins with a minus is an operand if it is only that, or no option and evidently a
/// polynomial. A bare `-x` is not: it is more often a mistyped option, and `-- -x` says the other thing.
bool OptionSet::is_operand(std::string_view argument) const {
    if (argument.empty() || argument[0] != '-' || argument.size() == 1) return true;
    if (argument[1] == '-') return false;
    const auto option = [this](char letter) { return app_->get_option_no_throw(std::string("-") + letter); };
    if (const CLI::Option* first = option(argument[1])) {
        // `-o+1` is an output file; of flags, only known ones combine.
        const bool all_known = std::all_of(argument.begin() + 1, argument.end(),
                                           [&](char letter) { return option(letter) != nullptr; });
        if (first->get_items_expected_max() > 0 || all_known) return false;
    }
    return std::any_of(argument.begin() + 1, argument.end(),
                       [](unsigned char c) { return std::isalpha(c) == 0; });
}

void OptionSet::reject(std::string_view argument) const {
    if (!argument.starts_with("--"))
        throw UsageError("unknown option '" + std::string(argument) +
                         "' (a polynomial that begins with a minus goes after '--')");
    const std::string_view name = argument.substr(2, argument.find('=') - 2);
    std::vector<std::string_view> known;
    for (const CLI::Option* option : app_->get_options()) {
        for (const std::string& long_name : option->get_lnames()) known.push_back(long_name);
    }
    std::string message = "unknown option '--" + std::string(name) + "'";
    if (const auto meant = nearest(name, known)) message += "; did you mean '--" + std::string(*meant) + "'?";
    throw UsageError(message);
}

std::vector<std::string> OptionSet::operands(std::span<const std::string> remaining) const {
    std::vector<std::string> result;
    bool options_may_follow = true;
    for (const std::string& argument : remaining) {
        if (options_may_follow && argument == "--") {
            options_may_follow = false;
            continue;
        }
        if (options_may_follow && argument.size() > 1 && argument[0] == '-') reject(argument);
        result.emplace_back(unprotected(argument));
    }
    return result;
}

/// Throws what CLI11 says less plainly: a flag with a value, an option without its value at the end.
void OptionSet::explain_mismatch(std::span<const std::string> arguments) const {
    for (const std::string& argument : arguments) {
        const std::size_t equals = argument.find('=');
        if (equals == std::string::npos || !argument.starts_with("--")) continue;
        const std::string name = argument.substr(0, equals);
        const CLI::Option* option = app_->get_option_no_throw(name);
        if (option != nullptr && option->get_items_expected_max() == 0)
            throw UsageError(name, "no value", "'" + argument.substr(equals + 1) + "'");
    }
    const CLI::Option* last = arguments.empty() ? nullptr : app_->get_option_no_throw(arguments.back());
    if (last != nullptr && last->get_items_expected_max() > 0)
        throw UsageError(arguments.back(), last->get_type_name(), "the end of the command line");
}

std::vector<std::string> OptionSet::read(std::span<const std::string> arguments, Reading reading) {
    app_->allow_extras(true);
    app_->prefix_command(reading == Reading::to_command);
    // CLI11 takes a leading minus for an option, and its arguments in reverse.
    std::vector<std::string> reversed;
    bool options_may_follow = true;
    for (const std::string& argument : arguments) {
        options_may_follow = options_may_follow && argument != "--";
        const bool looks_like_option = options_may_follow && argument.size() > 1 && argument[0] == '-';
        reversed.push_back(looks_like_option && is_operand(argument) ? std::string(protection) + argument
                                                                     : argument);
    }
    std::ranges::reverse(reversed);
    try {
        app_->parse(std::move(reversed));
    } catch (const CLI::ArgumentMismatch& error) {
        explain_mismatch(arguments);
        throw UsageError(error.what());
    } catch (const CLI::ParseError& error) {
        throw UsageError(error.what());
    }
    std::vector<std::string> remaining = app_->remaining();
    if (reading == Reading::all) return operands(remaining);
    if (!remaining.empty() && remaining.front() == "--")
        remaining.erase(remaining.begin());
    else if (!remaining.empty() && remaining.front().starts_with('-') && remaining.front() != "-")
        reject(remaining.front());
    for (std::string& argument : remaining) argument = std::string(unprotected(argument));
    return remaining;
}

std::string OptionSet::help() const {
    const auto formatter = std::dynamic_pointer_cast<CLI::Formatter>(app_->get_formatter());
    return formatter->make_groups(app_.get(), CLI::AppFormatMode::Normal);
}

} // namespace eliminant::app
