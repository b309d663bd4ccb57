/// \file
/// `eliminant verify`.
#include "certificate_json.hpp"
#include "command.hpp"
#include "input.hpp"
#include "results.hpp"

#include "eliminant/implicit/verify.hpp"

namespace eliminant::app {

namespace {

class VerifyCommand : public Command {
  public:
    std::string_view usage() const override { return "CERTIFICATE | -"; }

    std::string_view description() const override {
        return "Checks a certificate that `eliminant implicitize --certificate FILE` wrote, from scratch and "
               "without "
               "the\n"
               "code that found the equations, and says what was checked and how. Exit status 0 if all "
               "claims "
               "hold, 1 if\n"
               "one does not, 2 if the file is no certificate.\n"
               "\n"
               "Examples:\n"
               "  eliminant implicitize 'x = t^2' 'y = t^3' --certificate cusp.json\n"
               "  eliminant verify cusp.json\n";
    }

    void declare(OptionSet& /*options*/) override {}

    ExitStatus run(std::span<const std::string> operands, Session& session) override {
        require_text_or_json(session);
        const Input input = input_of(
            operands, [](std::string_view) { return false; }, session.run());
        const Input::Part& file = input.parts.front();
        const CertificateText text = certificate_from_json(SourceText(file.text, file.name));
        if (!text.digest_matches)
            return report(
                session, {false, "the certificate was changed after it was written: its digest differs", {}});
        return report(session, verify(text.certificate, session.run()));
    }

  private:
    static ExitStatus report(Session& session, const Verdict& verdict) {
        if (session.format() == ResultFormat::json) {
            Json json;
            json["valid"] = verdict.holds;
            json["statement"] = verdict.statement;
            json["checked"] = verdict.checked;
            session.write_result(to_text(json));
            return verdict.holds ? exit_done : exit_negative;
        }
        std::string lines;
        for (const std::string& sentence : verdict.checked) lines += "checked: " + sentence + "\n";
        lines += (verdict.holds ? "valid: " : "invalid: ") + verdict.statement + "\n";
        session.write_result(lines);
        return verdict.holds ? exit_done : exit_negative;
    }
};

} // namespace

std::unique_ptr<Command> make_verify() { return std::make_unique<VerifyCommand>(); }

} // namespace eliminant::app
