#include "eliminant/implicit/batch.hpp"

#include "base/parallel.hpp"
#include "eliminant/implicit/control_net.hpp"
#include "implicit/shape_keywords.hpp"
#include "implicit/text_lines.hpp"

#include <atomic>
#include <mutex>
#include <set>
#include <utility>
#include <variant>

namespace eliminant::implicit {

using base::SourceText;

namespace {

/// Whether a line is `patch NAME`, and not the equation of a coordinate named so.
bool begins_patch(const SourceText& line) {
    if (first_word(line) != "patch") return false;
    const std::size_t next = skip_blanks(line, skip_blanks(line, 0) + first_word(line).size());
    return next == line.size() || line.text()[next] != '=';
}

std::string patch_name(const SourceText& line) {
    const std::size_t begin = skip_blanks(line, skip_blanks(line, 0) + first_word(line).size());
    std::size_t end = line.size();
    while (end > begin && skip_blanks(line, end - 1) == line.size()) --end;
    if (begin >= end) line.fail(line.size(), "the name of the patch");
    return std::string(line.text().substr(begin, end - begin));
}

/// Where a shape begins, and the name that it has been given.
struct Start {
    std::size_t offset;
    std::string name;
};

/// The pieces of a net that is read; all that its reader leaves open are weights.
std::vector<NetPiece> pieces_of(const SourceText& text, base::Run& run) {
    const ControlNet net = parse_control_net(text, run);
    try {
        return net_pieces(net, run);
    } catch (const DomainError&) {
        text.fail(text.size(), "weights that are not all 0 on any piece", "a piece where they are");
    }
}

/// A shape that has been read, or the error of its source.
struct Item {
    std::string name;
    std::variant<Parametrization, std::exception_ptr> content;
};

std::vector<Item> read_all(std::span<const ShapeSource> sources, base::Run& run) {
    std::vector<Item> items;
    for (const ShapeSource& source : sources) {
        try {
            for (Shape& shape : parse_shapes(source, run))
                items.push_back({std::move(shape.name), std::move(shape.parametrization)});
        } catch (const Stopped&) {
            throw;
        } catch (const Error&) {
            items.push_back({source.name, std::current_exception()});
        }
    }
    return items;
}

ShapeResult treat(const Item& item, const ImplicitizeOptions& options, base::Run& run) {
    ShapeResult result{item.name, std::nullopt, nullptr, 0};
    if (const auto* error = std::get_if<std::exception_ptr>(&item.content)) {
        result.error = *error;
        return result;
    }
    try {
        const auto& parametrization = std::get<Parametrization>(item.content);
        result.coordinate_count = parametrization.coordinates().size();
        result.result = implicitize(parametrization, options, run);
    } catch (const Stopped&) {
        throw;
    } catch (const Error&) {
        result.error = std::current_exception();
    }
    return result;
}

} // namespace

std::vector<ShapeSource> shape_sources(const SourceText& source, base::Run& run) {
    std::vector<Start> starts;
    std::set<std::string> names;
    bool has_patches = false;
    bool has_net = false; // since the last patch line
    for_each_line(source, run, [&](const SourceText& line) {
        const auto offset = static_cast<std::size_t>(line.text().data() - source.text().data());
        if (begins_patch(line)) {
            if (!starts.empty() && !has_patches) {
                const SourceText first = source.section(starts[0].offset, source.size());
                first.fail(0, "patch NAME before the first of several shapes");
            }
            has_patches = true;
            has_net = false;
            std::string name = patch_name(line);
            if (!names.insert(name).second)
                line.fail(skip_blanks(line, 0), "a name that no other patch has", "'" + name + "'");
            starts.push_back({offset + line.size(), std::move(name)});
        } else if (begins_control_net(line)) {
            if (starts.empty() || (has_net && !has_patches)) starts.push_back({offset, {}});
            has_net = true;
        } else if (starts.empty()) {
            starts.push_back({offset, {}});
        }
    });
    if (starts.empty()) return {{"", source}};

    std::vector<ShapeSource> sources;
    for (std::size_t i = 0; i < starts.size(); ++i) {
        std::size_t end = i + 1 < starts.size() ? starts[i + 1].offset : source.size();
        // The next shape's own line `patch` is no part of this one.
        if (has_patches && i + 1 < starts.size()) end = source.text().rfind('\n', end - 1) + 1;
        std::string name = std::move(starts[i].name);
        if (!has_patches && starts.size() > 1) name = std::to_string(i + 1);
        sources.push_back({std::move(name), source.section(starts[i].offset, end)});
    }
    return sources;
}

std::vector<Shape> parse_shapes(const ShapeSource& source, base::Run& run) {
    bool is_net = false;
    bool is_first = true;
    for_each_line(source.text, run, [&](const SourceText& line) {
        if (std::exchange(is_first, false)) is_net = begins_control_net(line);
    });
    std::vector<Shape> shapes;
    if (!is_net) {
        shapes.push_back({source.name, parse_parametrization(std::span(&source.text, 1), run)});
        return shapes;
    }
    std::vector<NetPiece> pieces = pieces_of(source.text, run);
    for (NetPiece& piece : pieces) {
        std::string name = source.name;
        if (pieces.size() > 1) {
            name += '[';
            for (std::size_t i = 0; i < piece.span.size(); ++i)
                name.append(i == 0 ? "" : ",").append(std::to_string(piece.span[i]));
            name += ']';
        }
        shapes.push_back({std::move(name), std::move(piece.parametrization)});
    }
    return shapes;
}

void implicitize_shapes(std::span<const ShapeSource> sources, const ImplicitizeOptions& options,
                        base::Run& run, const std::function<void(const ShapeResult&)>& sink) {
    const std::vector<Item> items = read_all(sources, run);
    std::mutex mutex; // of what follows
    std::vector<std::optional<ShapeResult>> waiting(items.size());
    std::size_t next = 0;
    std::atomic<std::size_t> begun{0}; // so that shapes are begun in their sequence
    base::parallel_for(run, items.size(), [&](std::size_t, std::size_t) {
        const std::size_t i = begun++;
        ShapeResult result = treat(items[i], options, run);
        const std::lock_guard lock(mutex);
        waiting[i] = std::move(result);
        for (; next < items.size() && waiting[next]; ++next) {
            sink(*waiting[next]);
            waiting[next].reset();
        }
    });
}

} // namespace eliminant::implicit
