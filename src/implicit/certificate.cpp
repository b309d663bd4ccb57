#include "eliminant/implicit/certificate.hpp"

#include <string_view>

namespace eliminant::implicit {

namespace {

/// Fowler, Noll and Vo's hash of a sequence of texts and numbers; each is preceded by its length, so that
/// no two sequences are written alike.
class Fingerprint {
  public:
    void add(std::string_view text) {
        add_byte_string(std::to_string(text.size()));
        add_byte_string(":");
        add_byte_string(text);
    }
    void add(std::uint64_t number) { add(std::string_view(std::to_string(number))); }
    void add(const std::pair<std::string, std::string>& pair) {
        add(std::string_view(pair.first));
        add(std::string_view(pair.second));
    }
    void add(const std::string& text) { add(std::string_view(text)); }
    template <class T>
    void add(const std::vector<T>& list) {
        add(std::uint64_t{list.size()});
        for (const T& element : list) add(element);
    }
    void add(const VanishingClaim& claim) {
        add(claim.degrees);
        add(claim.total_degree);
        add(claim.height.get_str());
        add(claim.primes);
    }
    std::uint64_t value() const { return hash_; }

  private:
    void add_byte_string(std::string_view bytes) {
        for (const char byte : bytes) {
            hash_ ^= static_cast<unsigned char>(byte);
            hash_ *= 0x100000001b3;
        }
    }

    std::uint64_t hash_ = 0xcbf29ce484222325;
};

} // namespace

std::uint64_t digest(const Certificate& certificate) {
    Fingerprint hash;
    const auto& [input, equations, claims] = certificate;
    hash.add(input.parameters);
    hash.add(input.constants);
    hash.add(input.angles);
    hash.add(input.relations);
    hash.add(input.coordinates);
    hash.add(equations);
    hash.add(static_cast<std::uint64_t>(claims.theorem));
    hash.add(claims.codimension);
    hash.add(claims.degrees);
    hash.add(claims.vanishing);
    hash.add(claims.rank.prime);
    hash.add(claims.rank.point);
    hash.add(claims.rank.rank);
    hash.add(std::uint64_t{claims.rank.minor});
    if (claims.irreducible) {
        hash.add(claims.irreducible->prime);
        hash.add(claims.irreducible->base);
        hash.add(claims.irreducible->direction);
        hash.add(claims.irreducible->section);
    }
    if (claims.domain) {
        hash.add(claims.domain->weights);
        hash.add(claims.domain->prime);
        hash.add(claims.domain->rank);
        hash.add(claims.domain->points);
    }
    return hash.value();
}

} // namespace eliminant::implicit
