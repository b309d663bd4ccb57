/// \file
/// Certificates as JSON.
#pragma once

#include "eliminant/base/source_text.hpp"
#include "eliminant/implicit/certificate.hpp"

#include <string>

namespace eliminant::app {

/// An object of `input`, `equations`, `claims` and a `digest` of the three.
std::string certificate_to_json(const Certificate& certificate);

/// A certificate, and whether it is the one that the digest in the text was made of.
struct CertificateText {
    Certificate certificate;
    bool digest_matches = false;
};

/// \throws ParseError where the text is no JSON, DomainError where it is no certificate
CertificateText certificate_from_json(const SourceText& source);

} // namespace eliminant::app
