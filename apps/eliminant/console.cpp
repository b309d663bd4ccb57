#include "console.hpp"

#include <algorithm>
#include <iomanip>
#include <sstream>
#include <vector>

#include <sys/ioctl.h>
#include <unistd.h>

namespace eliminant::app {

namespace {

std::size_t terminal_width() {
    winsize size{};
    const bool known = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
    return known ? size.ws_col : 80;
}

/// Nobody can be told when standard error fails.
void write_to_standard_error(std::string_view text) {
    while (!text.empty()) {
        const ssize_t written = write(STDERR_FILENO, text.data(), text.size());
        if (written <= 0) return;
        text.remove_prefix(static_cast<std::size_t>(written));
    }
}

/// The first character: its bytes, all of them or one that is not UTF-8, and whether it may be printed.
struct Character {
    std::string_view bytes;
    bool printable;
};

Character first_character(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char lead = byte(0);
    if (lead < 0x80) return {text.substr(0, 1), lead >= 0x20 && lead != 0x7f};

    const std::size_t length = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
    bool valid = lead >= 0xc2 && lead <= 0xf4 && length <= text.size();
    for (std::size_t i = 1; valid && i < length; ++i) valid = (byte(i) & 0xc0) == 0x80;
    if (!valid) return {text.substr(0, 1), false};
    const bool control = lead == 0xc2 && byte(1) < 0xa0; // U+0080 … U+009F steer some terminals
    return {text.substr(0, length), !control};
}

std::string live_line(const Progress& progress, double seconds) {
    std::ostringstream line;
    line << std::fixed << std::setprecision(1) << seconds << " s  " << progress.phase;
    if (progress.done > 0 || progress.total > 0) line << ' ' << progress.done;
    if (progress.total > 0) {
        const double part = static_cast<double>(progress.done) / static_cast<double>(progress.total);
        line << '/' << progress.total << std::setprecision(0) << " (" << 100 * part << "%)";
    }
    if (!progress.note.empty()) line << ": " << progress.note;
    return line.str();
}

/// How long the rest takes if it goes on as in the seconds so far; nothing while that is a mere guess.
std::string remaining_time(const Progress& progress, double seconds) {
    constexpr double least_seconds = 0.5;
    if (progress.done == 0 || progress.done > progress.total || seconds < least_seconds) return {};
    const double left =
        seconds * static_cast<double>(progress.total - progress.done) / static_cast<double>(progress.done);
    std::ostringstream text;
    text << ", " << std::fixed << std::setprecision(left < 10 ? 1 : 0) << left << " s left";
    return text.str();
}

} // namespace

std::string printable(std::string_view text) {
    static constexpr std::string_view digits = "0123456789abcdef";
    std::string result;
    while (!text.empty()) {
        const Character character = first_character(text);
        if (character.printable) {
            result += character.bytes;
        } else {
            for (const char c : character.bytes) {
                const auto byte = static_cast<unsigned char>(c);
                result += {'\\', 'x', digits[byte >> 4], digits[byte & 15]};
            }
        }
        text.remove_prefix(character.bytes.size());
    }
    return result;
}

std::string excerpt(std::string_view line, std::size_t column, std::size_t width) {
    constexpr std::string_view indent = "  ";
    std::vector<std::string_view> cells; // one a column of the screen
    while (!line.empty()) {
        const Character character = first_character(line);
        const bool tab = character.bytes == "\t";
        cells.push_back(character.printable ? character.bytes : tab ? std::string_view(" ") : "\uFFFD");
        line.remove_prefix(character.bytes.size());
    }

    const std::size_t room = std::max<std::size_t>(width, 20) - indent.size() - 1;
    const std::size_t caret = std::min(column > 0 ? column - 1 : 0, cells.size());
    std::size_t begin = 0;
    if (caret >= room) begin = caret - room / 2;
    const std::size_t end = std::min(cells.size(), begin + room);

    std::string text(indent);
    for (std::size_t i = begin; i < end; ++i) text += cells[i];
    return text.append("\n").append(indent).append(caret - begin, ' ').append("^\n");
}

Console::Console() : terminal_(isatty(STDERR_FILENO) == 1) {}

void Console::error(std::string_view message) { say("eliminant: " + printable(message) + "\n"); }

void Console::error(const ParseError& error) {
    std::string text = "eliminant: " + printable(error.what()) + "\n";
    if (terminal_) text += excerpt(error.line_text(), error.where().column, terminal_width());
    say(text);
}

void Console::warning(std::string_view message) { say("eliminant: warning: " + printable(message) + "\n"); }

void Console::detail(std::string_view line) {
    if (verbose_) say(printable(line) + "\n");
}

void Console::expect_steady_progress() {
    const std::lock_guard lock(mutex_);
    steady_since_ = std::chrono::steady_clock::now();
}

void Console::show(const Progress& progress) {
    const auto now = std::chrono::steady_clock::now();
    const std::lock_guard lock(mutex_);
    std::string line = printable(live_line(progress, std::chrono::duration<double>(now - start_).count()));
    if (steady_since_)
        line += remaining_time(progress, std::chrono::duration<double>(now - *steady_since_).count());
    erase_live_line();
    // A line that fills the last column would wrap, and could not be erased.
    write_to_standard_error(line.substr(0, terminal_width() - 1));
    live_line_ = true;
}

void Console::clear_progress() {
    const std::lock_guard lock(mutex_);
    erase_live_line();
}

void Console::say(const std::string& text) {
    const std::lock_guard lock(mutex_);
    erase_live_line();
    write_to_standard_error(text);
}

void Console::erase_live_line() {
    if (live_line_) write_to_standard_error("\r\033[K");
    live_line_ = false;
}

} // namespace eliminant::app
