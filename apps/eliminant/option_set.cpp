#include "option_set.hpp"

#include "suggestion.hpp"

#include <algorithm>
#include <cctype>

namespace eliminant::app {

namespace {

std::string expected_found(std::string_view subject, std::string_view expected, std::string_view found) {
    std::string message(subject);
    message.append(": expected ").append(expected).append(", found ").append(found);
    return message;
}

/// Calls the setter so that its complaint names the option.
template <class Set>
void set_option(std::string_view shown, const Set& set, std::string_view value) {
    try {
        set(value);
    } catch (const ParseError&) { // it names the option as its source, and the place in it
        throw;
    } catch (const Error& error) {
        throw UsageError(std::string(shown) + ": " + error.what());
    }
}

} // namespace

UsageError::UsageError(std::string_view subject, std::string_view expected, std::string_view found)
    : Error(expected_found(subject, expected, found)) {}

void OptionSet::flag(std::string_view name, char short_name, std::string_view help, bool& target) {
    options_.push_back(
        {name, short_name, {}, help, heading_, [&target](std::string_view) { target = true; }});
}

void OptionSet::value(std::string_view name, char short_name, std::string argument, std::string_view help,
                      Setter set) {
    options_.push_back({name, short_name, std::move(argument), help, heading_, std::move(set)});
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

const OptionSet::Option* OptionSet::find(char short_name) const {
    const auto position = std::find_if(options_.begin(), options_.end(), [=](const Option& option) {
        return option.short_name != 0 && option.short_name == short_name;
    });
    return position == options_.end() ? nullptr : &*position;
}

const OptionSet::Option& OptionSet::find(std::string_view name) const {
    std::vector<std::string_view> names;
    for (const Option& option : options_) {
        if (option.name == name) return option;
        names.push_back(option.name);
    }
    std::string message = "unknown option '--" + std::string(name) + "'";
    if (const auto meant = nearest(name, names)) message += "; did you mean '--" + std::string(*meant) + "'?";
    throw UsageError(message);
}

/// An argument that begins with a minus is an operand if it is only that, or no option and evidently a
/// polynomial. A bare `-x` is not: it is more often a mistyped option, and `-- -x` says the other thing.
bool OptionSet::is_operand(std::string_view argument) const {
    if (argument.empty() || argument[0] != '-' || argument.size() == 1) return true;
    if (argument[1] == '-') return false;
    if (const Option* option = find(argument[1])) {
        // `-o+1` is an output file; of flags, only known ones combine.
        const bool all_known = std::all_of(argument.begin() + 1, argument.end(),
                                           [this](char letter) { return find(letter) != nullptr; });
        if (!option->argument.empty() || all_known) return false;
    }
    return std::any_of(argument.begin() + 1, argument.end(),
                       [](unsigned char c) { return std::isalpha(c) == 0; });
}

std::vector<std::string> OptionSet::read(std::span<const std::string> arguments, Reading reading) const {
    std::vector<std::string> operands;
    for (std::size_t at = 0; at < arguments.size(); ++at) {
        const std::string& argument = arguments[at];
        const bool end_of_options = argument == "--";
        if (end_of_options || (reading == Reading::to_command && is_operand(argument))) {
            const std::size_t first = at + (end_of_options ? 1 : 0);
            operands.insert(operands.end(), arguments.begin() + static_cast<std::ptrdiff_t>(first),
                            arguments.end());
            break;
        }
        if (is_operand(argument))
            operands.push_back(argument);
        else if (argument.starts_with("--"))
            read_long(arguments, at);
        else
            read_short(arguments, at);
    }
    return operands;
}

void OptionSet::read_long(std::span<const std::string> arguments, std::size_t& at) const {
    const std::string& argument = arguments[at];
    const std::size_t equals = argument.find('=');
    const std::string shown = argument.substr(0, equals);
    const Option& option = find(std::string_view(shown).substr(2));

    const bool attached = equals != std::string::npos;
    std::string_view value;
    if (attached) value = std::string_view(argument).substr(equals + 1);
    if (option.argument.empty()) {
        if (attached) throw UsageError(shown, "no value", "'" + std::string(value) + "'");
    } else if (!attached) {
        if (++at == arguments.size()) throw UsageError(shown, option.argument, "the end of the command line");
        value = arguments[at];
    }
    set_option(shown, option.set, value);
}

void OptionSet::read_short(std::span<const std::string> arguments, std::size_t& at) const {
    const std::string argument = arguments[at];
    for (std::size_t i = 1; i < argument.size(); ++i) {
        const std::string shown = std::string("-") + argument[i];
        const Option* option = find(argument[i]);
        if (option == nullptr)
            throw UsageError("unknown option '" + argument +
                             "' (a polynomial that begins with a minus goes after '--')");
        if (option->argument.empty()) {
            option->set({});
            continue;
        }
        std::string value = argument.substr(i + 1);
        if (value.empty()) {
            if (++at == arguments.size())
                throw UsageError(shown, option->argument, "the end of the command line");
            value = arguments[at];
        }
        set_option(shown, option->set, value);
        return;
    }
}

std::string OptionSet::help() const {
    // Two columns where the left one is short, otherwise the explanation goes below.
    constexpr std::size_t explanation_column = 30;
    std::string text;
    std::string_view heading;
    for (const Option& option : options_) {
        if (option.heading != heading) {
            heading = option.heading;
            text.append("\n").append(heading).append(":\n");
        }
        std::string left = option.short_name != 0 ? std::string("  -") + option.short_name + ", " : "      ";
        left.append("--").append(option.name);
        if (!option.argument.empty()) left.append(" ").append(option.argument);
        if (left.size() + 2 > explanation_column) {
            text.append(left).append("\n");
            left.clear();
        }
        left.resize(explanation_column, ' ');
        text.append(left);
        for (const char c : option.help) {
            text += c;
            if (c == '\n') text.append(explanation_column, ' ');
        }
        text += '\n';
    }
    return text;
}

} // namespace eliminant::app
