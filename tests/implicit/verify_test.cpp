// Certificates: those of results are accepted, changed ones are not.
#include "eliminant/implicit/certify.hpp"
#include "eliminant/implicit/verify.hpp"
#include "implicit/support.hpp"
#include "implicit/verify_irreducible.hpp"
#include "implicit/verify_values.hpp"

#include <functional>
#include <random>

namespace eliminant::implicit {
namespace {

Certificate certificate_of(const std::string& text, Method method = Method::automatic) {
    base::Run run;
    const Parametrization parametrization = parametrization_of(text);
    const ImplicitResult result = implicitize(parametrization, {.method = method}, run);
    const auto [certificate, reason] = certify(parametrization, result, run);
    EXPECT_TRUE(certificate) << text << "\n" << reason;
    return certificate.value_or(Certificate{});
}

bool holds(const Certificate& certificate) {
    base::Run run;
    try {
        return verify(certificate, run).holds;
    } catch (const DomainError&) {
        return false;
    } catch (const ParseError&) {
        return false;
    }
}

const std::vector<std::string> hypersurfaces = {
    "x = t^2-1\ny = t^3-t",
    "x = 3*t^4/(7*t^3+2)-5\ny = 11*t^2+t/(t+1)",
    "x = 3*s+3*s*t^2-s^3\ny = 3*t+3*s^2*t-t^3\nz = 3*s^2-3*t^2",
    "x = s*t/7+2*s\ny = s^2/3-5*t\nz = t^2*s/(s+4*t+9)",
    "x = (2+cos(u))*cos(v)\ny = (2+cos(u))*sin(v)\nz = sin(u)",
    "constants R, r\nx = (R+r*cos(u))*cos(v)\ny = (R+r*cos(u))*sin(v)\nz = r*sin(u)",
    "constants a\nx = t^2+a*t+3\ny = a*t^3-7*t",
    "x = s*t\ny = s^2+u\nz = t*u\nw = s+t+5*u",
};

TEST(Verify, AcceptsTheCertificatesOfResults) {
    for (const std::string& text : hypersurfaces) {
        for (const Method method : {Method::automatic, Method::groebner}) {
            const Certificate certificate = certificate_of(text, method);
            EXPECT_EQ(certificate.claims.theorem, Theorem::hypersurface) << text;
            EXPECT_TRUE(holds(certificate)) << text;
        }
    }
    for (const char* text :
         {"x = t\ny = t^2\nz = t^3", "x = 3\ny = 4", "constants r\nx = t\ny = r*t\nz = t^2+r"}) {
        const Certificate certificate = certificate_of(text);
        EXPECT_EQ(certificate.claims.theorem, Theorem::elimination) << text;
        EXPECT_TRUE(holds(certificate)) << text;
    }
    const Certificate dense = certificate_of("x = s\ny = s*t");
    EXPECT_EQ(dense.claims.theorem, Theorem::dense);
    EXPECT_TRUE(holds(dense));
}

/// The text with its n-th number replaced by the next one, or nothing if it has no so many.
std::optional<std::string> with_number_changed(const std::string& text, std::size_t n) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool in_name =
            i > 0 && (std::isalnum(static_cast<unsigned char>(text[i - 1])) != 0 || text[i - 1] == '_');
        if (std::isdigit(static_cast<unsigned char>(text[i])) == 0 || in_name) continue;
        std::size_t end = i;
        while (end < text.size() && std::isdigit(static_cast<unsigned char>(text[end])) != 0) ++end;
        if (count++ == n)
            return text.substr(0, i) + mpz_class(mpz_class(text.substr(i, end - i)) + 1).get_str() +
                   text.substr(end);
        i = end;
    }
    return std::nullopt;
}

/// Certificates with one coefficient, exponent, degree, prime or other number changed, each with a
/// description.
std::vector<std::pair<std::string, Certificate>> mutants(const Certificate& original) {
    std::vector<std::pair<std::string, Certificate>> result;
    const auto with = [&](const std::string& what, const std::function<void(Certificate&)>& change) {
        result.emplace_back(what, original);
        change(result.back().second);
    };
    for (std::size_t e = 0; e < original.equations.size(); ++e)
        for (std::size_t i = 0;; ++i) {
            const auto changed = with_number_changed(original.equations[e], i);
            if (!changed) break;
            with("equation: " + *changed, [&](Certificate& c) { c.equations[e] = *changed; });
        }
    with("an equation more", [](Certificate& c) { c.equations.push_back(c.equations.front()); });
    with("sign", [](Certificate& c) { c.equations.front() = "-(" + c.equations.front() + ")"; });
    with("multiple", [](Certificate& c) { c.equations.front() = "2*(" + c.equations.front() + ")"; });
    with("square", [](Certificate& c) { c.equations.front() = "(" + c.equations.front() + ")^2"; });
    with("codimension", [](Certificate& c) { ++c.claims.codimension; });
    with("degree", [](Certificate& c) { ++c.claims.degrees.front(); });
    with("theorem", [](Certificate& c) { c.claims.theorem = Theorem::dense; });
    for (std::size_t i = 0; i < original.claims.vanishing.front().degrees.size(); ++i) {
        with("bound of a degree", [&](Certificate& c) { ++c.claims.vanishing.front().degrees[i]; });
        with("bound of a degree", [&](Certificate& c) { --c.claims.vanishing.front().degrees[i]; });
    }
    with("bound of the degree", [](Certificate& c) { ++c.claims.vanishing.front().total_degree; });
    with("height", [](Certificate& c) { ++c.claims.vanishing.front().height; });
    with("prime missing", [](Certificate& c) { c.claims.vanishing.front().primes.pop_back(); });
    for (std::size_t i = 0; i < original.claims.vanishing.front().primes.size(); ++i) {
        with("no prime", [&](Certificate& c) { ++c.claims.vanishing.front().primes[i]; });
        with("another prime", [&](Certificate& c) { c.claims.vanishing.front().primes[i] = 2147483647; });
        with("zero for a prime", [&](Certificate& c) { c.claims.vanishing.front().primes[i] = 0; });
    }
    with("rank", [](Certificate& c) { ++c.claims.rank.rank; });
    with("minor", [](Certificate& c) { ++c.claims.rank.minor; });
    with("no prime of the rank", [](Certificate& c) { --c.claims.rank.prime; });
    with("no prime of the rank", [](Certificate& c) { c.claims.rank.prime = 0; });
    with("a point of another space", [](Certificate& c) { c.claims.rank.point.push_back(0); });
    with("no residue",
         [](Certificate& c) { c.claims.rank.point.assign(c.claims.rank.point.size() + 1, ~0U); });
    if (!original.claims.irreducible) return result;
    const auto with_section = [&](const std::string& what, const std::function<void(SectionClaim&)>& change) {
        with(what, [&](Certificate& c) { change(*c.claims.irreducible); });
    };
    with_section("no prime of the line", [](SectionClaim& s) { --s.prime; });
    with_section("too large a prime", [](SectionClaim& s) { s.prime = 2147483647; });
    with_section("prime 2", [](SectionClaim& s) { s.prime = 2; });
    with_section("longer base", [](SectionClaim& s) { s.base.push_back(0); });
    with_section("longer direction", [](SectionClaim& s) { s.direction.push_back(0); });
    for (std::size_t i = 0; i < original.claims.irreducible->section.size(); ++i)
        with_section("section", [&](SectionClaim& s) { ++s.section[i]; });
    with_section("shorter section", [](SectionClaim& s) { s.section.pop_back(); });
    with_section("no direction", [](SectionClaim& s) { s.direction.assign(s.direction.size(), 0); });
    for (std::size_t i = 0; i < original.claims.irreducible->base.size(); ++i) {
        with_section("another line", [&](SectionClaim& s) { s.base[i] = (s.base[i] + 1) % 1000003; });
        with_section("another direction",
                     [&](SectionClaim& s) { s.direction[i] = (s.direction[i] + 1) % 1000003; });
    }
    with("no section", [](Certificate& c) { c.claims.irreducible.reset(); });
    return result;
}

TEST(Verify, RejectsEveryCertificateWithOneNumberChanged) {
    for (const std::string& text : hypersurfaces) {
        const Certificate certificate = certificate_of(text);
        std::size_t count = 0;
        for (const auto& [what, changed] : mutants(certificate)) {
            EXPECT_NE(digest(changed), digest(certificate)) << what;
            // A line may be moved in the directions that an equation does not contain.
            if (what == "another line") continue;
            EXPECT_FALSE(holds(changed)) << text << "\n" << what;
            ++count;
        }
        EXPECT_GT(count, 20U);
    }
    for (const char* text : {"x = t\ny = t^2\nz = t^3", "x = 2*t^2\ny = 3*t^4\nz = 5*t^6+t^2"})
        for (const auto& [what, changed] : mutants(certificate_of(text))) {
            if (what == "sign" || what == "an equation more") continue;
            EXPECT_FALSE(holds(changed)) << text << "\n" << what;
        }
}

TEST(Verify, RejectsAnotherInput) {
    for (const std::string& text : hypersurfaces) {
        const Certificate certificate = certificate_of(text);
        for (std::size_t k = 0; k < certificate.input.coordinates.size(); ++k)
            for (std::size_t i = 0;; ++i) {
                const auto changed = with_number_changed(certificate.input.coordinates[k].second, i);
                if (!changed) break;
                Certificate other = certificate;
                other.input.coordinates[k].second = *changed;
                EXPECT_FALSE(holds(other)) << text << "\n" << *changed;
            }
    }
}

TEST(Verify, RejectsMultiplesAndPowersWithHonestBounds) {
    // All bounds are computed for the wrong polynomial, which vanishes; only irreducibility tells.
    base::Run run;
    for (const char* wrong : {"(x^3-y^2)^2", "(x^3-y^2)*(x+y+1)", "(x^3-y^2)*x"}) {
        const Parametrization cusp = parametrization_of("x = t^2\ny = t^3");
        ImplicitResult result = implicitize(cusp, {.method = Method::linear}, run);
        result.equations.front() = parse_polynomial(result.ring, SourceText(wrong, "test"));
        result.claims.reset();
        const auto certificate = certify(cusp, result, run).certificate;
        ASSERT_TRUE(certificate);
        EXPECT_EQ(certificate->claims.theorem, Theorem::elimination); // no irreducible section was found
        Certificate lie = *certificate;
        lie.claims.theorem = Theorem::hypersurface;
        lie.claims.irreducible = certificate_of("x = t^2\ny = t^3", Method::linear).claims.irreducible;
        EXPECT_FALSE(holds(lie)) << wrong;
    }
}

const std::vector<std::string> hypersurfaces_over_domains = {
    "x = s+t^2\ny = s*t\nrelation s^2 = 2",     // irreducible, but not over the algebraic closure
    "x = s\ny = t\nrelation s^4-10*s^2+1 = 0",  // reducible modulo every prime
    "x = s+t^2\ny = s^3*t+t\nrelation s*t = 0", // two components, each with its image
    "x = s/(t-1)\ny = t\nrelation (s-2*t)*(t-1)*(s^2+t)^2 = 0", // one of which is not in the domain
    "x = u^2-v\ny = u*v+w\nz = v*w\nrelation u^2+v^2+w^2 = 1",
    "x = a*c\ny = a*d+b\nz = b*c\nrelation a^2+b^2=1\nrelation c^2+d^2=2",
    "x = a*b\ny = c+d\nz = c*d\nrelation a^2+b^2+c^2+d^2=1\nrelation a*b+c*d=1/3",
    "x = cos(u)*s\ny = sin(u)*t\nz = s\nrelation s^2+t^2 = 1",
    "constants r\nx = u*v\ny = v*w\nz = u*w\nrelation u^2+v^2+w^2 = r^2",
    "constants r\nx = u/r\ny = v\nrelation r*(u*v-1) = 0",
    "x = s\ny = 1/t\nrelation t = 3",
};

TEST(Verify, AcceptsHypersurfacesWithRelations) {
    for (const std::string& text : hypersurfaces_over_domains) {
        const Certificate certificate = certificate_of(text);
        EXPECT_EQ(certificate.claims.theorem, Theorem::hypersurface) << text;
        EXPECT_TRUE(holds(certificate)) << text;
    }
    for (const char* text : {"x = s\ny = t\nz = s*t\nrelation s^3 = t^2",
                             "x = s\ny = t\nrelation s^2+t^2 = 1\nrelation s = 1/2"}) {
        const Certificate certificate = certificate_of(text);
        EXPECT_EQ(certificate.claims.theorem, Theorem::elimination) << text;
        EXPECT_TRUE(holds(certificate)) << text;
    }
    const Certificate dense = certificate_of("x = s+u\ny = t\nrelation s^2+t^2 = 1");
    EXPECT_EQ(dense.claims.theorem, Theorem::dense);
    EXPECT_TRUE(holds(dense));
}

TEST(Verify, RejectsEveryCertificateWithRelationsAndOneNumberChanged) {
    for (const std::string& text : hypersurfaces_over_domains) {
        const Certificate certificate = certificate_of(text);
        const auto rejects = [&](const std::string& what, const std::function<void(Certificate&)>& change) {
            Certificate changed = certificate;
            change(changed);
            EXPECT_NE(digest(changed), digest(certificate)) << what;
            EXPECT_FALSE(holds(changed)) << text << "\n" << what;
        };
        for (std::size_t i = 0;; ++i) {
            const auto changed = with_number_changed(certificate.equations.front(), i);
            if (!changed) break;
            rejects("equation " + *changed, [&](Certificate& c) { c.equations.front() = *changed; });
        }
        for (std::size_t k = 0; k < certificate.input.relations.size(); ++k)
            for (std::size_t i = 0;; ++i) {
                const auto changed = with_number_changed(certificate.input.relations[k], i);
                if (!changed) break;
                rejects("relation " + *changed, [&](Certificate& c) { c.input.relations[k] = *changed; });
            }
        rejects("square", [](Certificate& c) {
            c.equations.front() = "(" + c.equations.front() + ")^2";
            c.claims.degrees.front() *= 2;
        });
        rejects("multiple", [](Certificate& c) {
            const std::string x = c.input.coordinates.front().first;
            c.equations.front() = "(" + x + "+5)*(" + c.equations.front() + ")";
            ++c.claims.degrees.front();
        });
        rejects("degree", [](Certificate& c) { ++c.claims.degrees.front(); });
        rejects("codimension", [](Certificate& c) { ++c.claims.codimension; });
        rejects("theorem", [](Certificate& c) { c.claims.theorem = Theorem::dense; });
        rejects("no relations", [](Certificate& c) { c.input.relations.clear(); });
        rejects("no domain", [](Certificate& c) { c.claims.domain.reset(); });
        rejects("rank", [](Certificate& c) { ++c.claims.domain->rank; });
        rejects("prime", [](Certificate& c) { c.claims.domain->prime = 1073741827; });
        rejects("no prime", [](Certificate& c) { c.claims.domain->prime = 0; });
        rejects("weights", [](Certificate& c) { c.claims.domain->weights.pop_back(); });
        rejects("a weight of zero", [](Certificate& c) { c.claims.domain->weights.front() = 0; });
        rejects("a point less", [](Certificate& c) { c.claims.domain->points.pop_back(); });
        rejects("a point twice", [](Certificate& c) {
            auto& points = c.claims.domain->points;
            points.push_back(points.front());
        });
        rejects("no residue", [](Certificate& c) { c.claims.domain->points.front().front() = ~0U; });
        rejects("a value less", [](Certificate& c) { c.claims.domain->points.front().pop_back(); });
    }
}

TEST(Verify, SaysWhyThereIsNoCertificateForSomeRelations) {
    base::Run run;
    // The second relation is zero on the domain if its square is, which division does not find.
    const Parametrization p =
        parametrization_of("x = s\ny = t\nrelation s*(s-1) = 0\nrelation t*(t-1)*(t-s) = 0");
    const Certified certified = certify(p, implicitize(p, {}, run), run);
    EXPECT_FALSE(certified.certificate);
    EXPECT_NE(certified.reason.find("combination of the relations"), std::string::npos);
    Certificate certificate = certificate_of("x = s\ny = t");
    certificate.input.relations = {"s-t"};
    EXPECT_FALSE(holds(certificate));
}

TEST(Verify, MalformedCertificatesAreErrors) {
    const Certificate certificate = certificate_of("x = cos(u)\ny = sin(u)*t\nz = t");
    const auto rejected = [&](const std::function<void(Certificate&)>& change) {
        base::Run run;
        Certificate changed = certificate;
        change(changed);
        try {
            verify(changed, run);
        } catch (const Error&) {
            return true;
        }
        return false;
    };
    EXPECT_FALSE(rejected([](Certificate&) {}));
    EXPECT_TRUE(rejected([](Certificate& c) { c.equations.front() += "+"; }));
    EXPECT_TRUE(rejected([](Certificate& c) { c.equations.front() += "+q"; }));
    EXPECT_TRUE(rejected([](Certificate& c) { c.input.relations = {"0"}; }));
    EXPECT_TRUE(rejected([](Certificate& c) { c.input.relations = {"t+q"}; }));
    EXPECT_TRUE(rejected([](Certificate& c) { c.input.parameters.push_back(c.input.parameters.front()); }));
    EXPECT_TRUE(rejected([](Certificate& c) { c.input.angles.push_back(c.input.angles.front()); }));
    EXPECT_TRUE(rejected([](Certificate& c) { c.input.angles.front().first = "nobody"; }));
    EXPECT_TRUE(rejected([](Certificate& c) { c.input.coordinates.front().second = "1/0"; }));
    EXPECT_TRUE(rejected([](Certificate& c) { c.input.coordinates.front().first = "z"; }));
}

TEST(ValuesModulo, AgreeWithEvaluation) {
    base::Run run;
    const Ring ring(CoefficientField::rationals(), {"x", "y", "z"});
    std::mt19937_64 random(1);
    for (const std::uint32_t p : {1073741789U, 1048573U, 3U}) {
        const PrimeField field(p);
        for (const char* text : {"0", "7", "x", "z^5", "x^2*y^3+5*x^2*y+7", "x^9*z-3/7*y^2*z^4+x*y*z-11",
                                 "(x+y+z+1)^12", "(1+x)^40*(2-y)*(z+3)^3"}) {
            const Polynomial f = parse_polynomial(ring, SourceText(text, "test"));
            for (unsigned fixed = 0; fixed < 8; ++fixed) { // each set of variables
                const ExponentTree tree(f, {(fixed & 1) != 0, (fixed & 2) != 0, (fixed & 4) != 0});
                ValuesModulo values(tree, f, field);
                std::array<ValuesModulo::Lanes, 3> points{};
                for (auto& coordinate : points)
                    for (auto& value : coordinate) value = static_cast<std::uint32_t>(random() % p);
                values.fix(points);
                for (int round = 0; round < 2; ++round) {
                    for (std::size_t i = 0; i < 3; ++i)
                        if ((fixed >> i & 1) == 0) points[i][0] = static_cast<std::uint32_t>(random() % p);
                    const ValuesModulo::Lanes found = values(points);
                    for (std::size_t lane = 0; lane < ValuesModulo::lanes; ++lane) {
                        const std::array<std::uint32_t, 3> point = {points[0][lane], points[1][lane],
                                                                    points[2][lane]};
                        EXPECT_EQ(found[lane], evaluate(f, field, point, run)) << text << " " << p;
                    }
                }
            }
        }
    }
}

TEST(EvaluationLoops, EveryVectorUnitAgreesWithTheDefinition) {
    constexpr std::size_t lanes = evaluation_lanes;
    std::mt19937_64 random(3);
    for (const std::uint32_t p : {1073741789U, 65537U, 3U}) {
        const PrimeField field(p);
        const MontgomeryModulus modulus(p);
        const auto residues = [&](std::size_t count) {
            std::vector<std::uint32_t> list(count);
            for (auto& r : list) r = p - 1 - static_cast<std::uint32_t>(random() % std::min(p, 100U));
            return list;
        };
        // Nodes with 0, 1, …, 39 children: the greatest residues, so that sums are near their bound.
        std::vector<std::uint32_t> first_child = {0};
        for (std::uint32_t i = 0; i < 40; ++i) first_child.push_back(first_child.back() + i);
        const std::size_t children = first_child.back();
        std::vector<std::uint32_t> exponents(children);
        for (auto& e : exponents) e = static_cast<std::uint32_t>(random() % 20);
        const std::vector<std::uint32_t> x = residues(lanes);
        const std::vector<std::uint32_t> values = residues(children * lanes);
        const TreeEdges edges{first_child.data(), 40, exponents.data()};
        for (const base::VectorUnit unit : base::available_vector_units()) {
            const EvaluationLoops loops = evaluation_loops(unit);
            std::vector<std::uint64_t> powers(20 * lanes);
            loops.powers(powers.data(), x.data(), 20, modulus);
            for (std::size_t i = 0; i < powers.size(); ++i)
                ASSERT_EQ(powers[i], field.multiply(field.power(x[i % lanes], i / lanes),
                                                    field.reduce(std::uint64_t{1} << 32)));
            std::vector<std::uint32_t> sums(40 * lanes);
            std::vector<std::uint32_t> of_leaves(40 * lanes);
            loops.sums(sums.data(), edges, powers.data(), values.data(), modulus);
            loops.sums_of_leaves(of_leaves.data(), edges, powers.data(), values.data(), modulus);
            for (std::size_t i = 0; i < sums.size(); ++i) {
                std::uint32_t sum = 0;
                std::uint32_t sum_of_leaves = 0;
                for (std::size_t j = first_child[i / lanes]; j < first_child[i / lanes + 1]; ++j) {
                    const std::uint32_t power = field.power(x[i % lanes], exponents[j]);
                    sum = field.add(sum, field.multiply(power, values[j * lanes + i % lanes]));
                    sum_of_leaves = field.add(sum_of_leaves, field.multiply(power, values[j]));
                }
                ASSERT_EQ(sums[i], sum) << base::name(unit);
                ASSERT_EQ(of_leaves[i], sum_of_leaves) << base::name(unit);
            }
        }
    }
}

TEST(IsIrreducible, AgreesWithProductsAndKnownCases) {
    base::Run run;
    const PrimeField field(1048573);
    std::mt19937_64 random(2);
    EXPECT_TRUE(is_irreducible({5, 1}, field, run));
    EXPECT_FALSE(is_irreducible({1}, field, run));
    EXPECT_FALSE(is_irreducible({0, 0, 1}, field, run)); // x²
    // x² − a is irreducible iff a is no square: half of them are.
    int irreducible = 0;
    for (std::uint32_t a = 1; a <= 200; ++a) {
        const bool square = field.power(a, (field.characteristic() - 1) / 2) == 1;
        EXPECT_EQ(is_irreducible({field.negate(a), 0, 1}, field, run), !square);
        irreducible += square ? 0 : 1;
    }
    EXPECT_GT(irreducible, 50);
    for (int round = 0; round < 50; ++round) { // products are reducible
        std::vector<std::uint32_t> product(9, 0);
        std::vector<std::uint32_t> a(5, 1);
        std::vector<std::uint32_t> b(5, 1);
        for (std::size_t i = 0; i < 4; ++i) a[i] = static_cast<std::uint32_t>(random() % 1048573);
        for (std::size_t i = 0; i < 4; ++i) b[i] = static_cast<std::uint32_t>(random() % 1048573);
        for (std::size_t i = 0; i < 5; ++i)
            for (std::size_t j = 0; j < 5; ++j)
                product[i + j] = field.add(product[i + j], field.multiply(a[i], b[j]));
        EXPECT_FALSE(is_irreducible(product, field, run));
    }
}

} // namespace
} // namespace eliminant::implicit
