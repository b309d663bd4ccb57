#include "eliminant/algebra/parse.hpp"
#include "eliminant/implicit/control_net.hpp"
#include "implicit/shape_keywords.hpp"
#include "implicit/text_lines.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace eliminant::implicit {

using base::SourceText;

namespace {

constexpr std::size_t max_degree = 10000;

/// A token between blanks and commas.
struct Token {
    std::size_t begin;
    std::size_t end;
};

std::vector<Token> tokens_of(const SourceText& line, std::size_t offset) {
    constexpr std::string_view separators = " \t\r\f\v,";
    std::vector<Token> tokens;
    while ((offset = line.text().find_first_not_of(separators, offset)) != std::string_view::npos) {
        const std::size_t end = std::min(line.text().find_first_of(separators, offset), line.size());
        tokens.push_back({offset, end});
        offset = end;
    }
    return tokens;
}

std::vector<mpq_class> numbers_of(const SourceText& line, std::size_t offset) {
    std::vector<mpq_class> numbers;
    for (const Token& token : tokens_of(line, offset))
        numbers.push_back(algebra::parse_rational(line.section(token.begin, token.end)));
    return numbers;
}

class NetReader {
  public:
    explicit NetReader(base::Run& run) : run_(run) {}

    ControlNet read(const SourceText& source) {
        for_each_line(source, run_, [this](const SourceText& line) { read_statement(line); });
        if (net_.directions.empty()) source.fail(source.size(), "a control net, as bezier 3 3");
        finish(source);
        return std::move(net_);
    }

  private:
    void read_statement(const SourceText& line) {
        const std::string_view word = first_word(line);
        const std::size_t begin = skip_blanks(line, 0);
        if (net_.directions.empty())
            read_kind(line);
        else if (word == "coordinates")
            read_coordinates(line, begin + word.size());
        else if (word == "knots")
            read_knots(line, begin + word.size());
        else
            read_point(line);
    }

    void read_kind(const SourceText& line) {
        std::size_t begin = skip_blanks(line, 0);
        if (!begins_control_net(line))
            line.fail(begin, "bezier, triangle, rational bezier, rational triangle, bspline or nurbs");
        std::string_view word = first_word(line);
        std::size_t end = begin + word.size();
        if (word == "rational") {
            net_.is_rational = true;
            begin = skip_blanks(line, end);
            end = skip_word(line, begin);
            word = line.text().substr(begin, end - begin);
            if (word != "bezier" && word != "triangle") line.fail(begin, "bezier or triangle");
        }
        net_.is_rational |= word == "nurbs";
        net_.is_triangular = word == "triangle";
        is_spline_ = word == "bspline" || word == "nurbs";
        for (const Token& token : tokens_of(line, end)) {
            if (net_.directions.size() == (net_.is_triangular ? 1 : 2))
                line.fail(token.begin, "the end of the line");
            const mpq_class degree = algebra::parse_rational(line.section(token.begin, token.end));
            if (degree.get_den() != 1 || degree < 1 || degree > max_degree)
                line.fail(token.begin, "a degree from 1 to " + std::to_string(max_degree));
            net_.directions.push_back({degree.get_num().get_ui()});
        }
        if (net_.directions.empty()) line.fail(line.size(), "a degree");
    }

    void read_coordinates(const SourceText& line, std::size_t end) {
        if (!net_.coordinates.empty()) line.fail(skip_blanks(line, 0), "coordinates once");
        if (!net_.points.empty()) line.fail(skip_blanks(line, 0), "coordinates before the points");
        net_.coordinates = algebra::parse_names(line.section(end, line.size()));
    }

    void read_knots(const SourceText& line, std::size_t end) {
        const std::size_t begin = skip_blanks(line, 0);
        if (!is_spline_) line.fail(begin, "a control point: a Bézier net has no knots");
        if (knot_lines_ == net_.directions.size()) line.fail(begin, "one line of knots a degree");
        if (!net_.points.empty()) line.fail(begin, "knots before the points");
        ControlNet::Direction& direction = net_.directions[knot_lines_++];
        for (const Token& token : tokens_of(line, end)) {
            mpq_class knot = algebra::parse_rational(line.section(token.begin, token.end));
            if (!direction.knots.empty() && knot < direction.knots.back())
                line.fail(token.begin, "a knot that is not below the one before it");
            direction.knots.push_back(std::move(knot));
        }
        const std::size_t least = 2 * direction.degree + 2;
        if (direction.knots.size() < least)
            line.fail(line.size(),
                      "at least " + std::to_string(least) + " knots for degree " +
                          std::to_string(direction.degree),
                      std::to_string(direction.knots.size()));
        // The domain is from the knot number `degree` to the one as far from the end.
        if (direction.knots[direction.degree] == direction.knots[direction.point_count()])
            line.fail(skip_blanks(line, end), "knots of which some differ in the middle");
    }

    void read_point(const SourceText& line) {
        const std::size_t begin = skip_blanks(line, 0);
        if (is_spline_ && knot_lines_ < net_.directions.size())
            line.fail(begin, knot_lines_ == 0 ? "knots" : "the knots of the second degree");
        if (net_.points.size() == net_.point_count())
            line.fail(begin, "no more than " + std::to_string(net_.point_count()) + " control points");
        std::vector<mpq_class> point = numbers_of(line, 0);
        if (net_.coordinates.empty()) name_coordinates(line, point.size());
        const std::size_t expected = net_.coordinates.size() + (net_.is_rational ? 1 : 0);
        if (point.size() != expected) {
            const std::string weight = net_.is_rational ? " and a weight" : "";
            const std::string numbers = std::to_string(net_.coordinates.size()) + " coordinates" + weight;
            const auto tokens = tokens_of(line, 0);
            line.fail(point.size() < expected ? line.size() : tokens[expected].begin, numbers,
                      std::to_string(point.size()) + (point.size() == 1 ? " number" : " numbers"));
        }
        net_.points.push_back(std::move(point));
    }

    /// Without a list of names the first point tells how many coordinates there are.
    void name_coordinates(const SourceText& line, std::size_t numbers) {
        const std::size_t weights = net_.is_rational ? 1 : 0;
        if (numbers != 2 + weights && numbers != 3 + weights)
            line.fail(skip_blanks(line, 0),
                      "2 or 3 coordinates" + std::string(weights ? " and a weight" : ""),
                      std::to_string(numbers) + (numbers == 1 ? " number" : " numbers"));
        net_.coordinates = {"x", "y", "z"};
        net_.coordinates.resize(numbers - weights);
    }

    void finish(const SourceText& source) const {
        if (is_spline_ && knot_lines_ < net_.directions.size()) source.fail(source.size(), "knots");
        if (net_.points.size() < net_.point_count())
            source.fail(source.size(), std::to_string(net_.point_count()) + " control points",
                        std::to_string(net_.points.size()));
    }

    base::Run& run_;
    ControlNet net_;
    bool is_spline_ = false;
    std::size_t knot_lines_ = 0;
};

} // namespace

bool begins_control_net(const SourceText& line) {
    const std::string_view word = first_word(line);
    constexpr std::array<std::string_view, 5> kinds = {"bezier", "triangle", "rational", "bspline", "nurbs"};
    if (std::ranges::find(kinds, word) == kinds.end()) return false;
    // A coordinate may have that name.
    const std::size_t next = skip_blanks(line, skip_blanks(line, 0) + word.size());
    return next == line.size() || line.text()[next] != '=';
}

ControlNet parse_control_net(const SourceText& source, base::Run& run) { return NetReader(run).read(source); }

} // namespace eliminant::implicit
