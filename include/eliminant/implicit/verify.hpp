/// \file
/// Checking a certificate, with polynomial arithmetic alone.
#pragma once

#include "eliminant/base/run.hpp"
#include "eliminant/implicit/certificate.hpp"

#include <string>
#include <vector>

namespace eliminant::implicit {

/// What came of checking a certificate.
struct Verdict {
    bool holds = false;
    std::string statement;            ///< what is proved, if it holds; otherwise what failed
    std::vector<std::string> checked; ///< what was found right, and how, a sentence each
};

/// Checks every claim of a certificate from scratch. Nothing is used of the code that found the equations,
/// and nothing is believed that is not computed again; what a theorem cannot be asked for by algebra alone
/// (Theorem::elimination) the statement says.
/// \throws ParseError, DomainError if the certificate is malformed: a formula that is none, a name that is
/// unknown or used twice; Stopped
Verdict verify(const Certificate& certificate, base::Run& run);

} // namespace eliminant::implicit

namespace eliminant {
using implicit::Verdict;
using implicit::verify;
} // namespace eliminant
