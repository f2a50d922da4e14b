// SPDX-License-Identifier: MIT
// Prints docs/issues.md from the issue table.
#include <fmt/format.h>

#include <string>
#include <string_view>

#include "base/issue.hpp"

namespace {

using posepack::base::ExitCode;
using posepack::base::IssueKind;
using posepack::base::Severity;

struct ExitCodeRow {
    ExitCode code;
    std::string_view meaning;
};

constexpr ExitCodeRow kExitCodes[] = {
    {ExitCode::ok, "Done; there may be warnings on stderr."},
    {ExitCode::usage, "The command line could not be understood."},
    {ExitCode::io, "A file or folder could not be read, written or locked."},
    {ExitCode::malformed_glb, "A GLB breaks a rule of glTF 2.0."},
    {ExitCode::malformed_catalog, "A catalog is malformed, or does not fit its models."},
    {ExitCode::unsupported, "An input is valid, but posepack does not support it."},
    {ExitCode::limit, "An input is over a limit."},
    {ExitCode::bad_container, "A container or manifest is malformed."},
    {ExitCode::mismatch, "Containers and manifest do not fit each other."},
    {ExitCode::partial, "Some animals failed under `--keep-going`; the others were baked."},
    {ExitCode::internal, "A fault of posepack itself; please report it."},
    {ExitCode::interrupted, "Interrupted by the user."},
};

void print_introduction() {
    fmt::print(
        "# Issues\n\n"
        "What posepack can report. Every finding is one line on stderr:\n\n"
        "```\n"
        "posepack: error[E-GLB-MAGIC]: deer.glb: expected 'glTF', found 'glTG'; try: export as binary glTF "
        "(.glb)\n"
        "```\n\n"
        "The code in brackets never changes its meaning and is never used again for another; the words "
        "around "
        "it may\n"
        "change. Text from inputs is escaped. With several failures the exit code is that of the first "
        "animal "
        "in the\n"
        "order of ids, whatever the number of threads.\n\n");
}

void print_exit_codes() {
    fmt::print("## Exit codes\n\n| code | meaning |\n|---:|---|\n");
    for (const ExitCodeRow& row : kExitCodes) {
        fmt::print("| {} | {} |\n", static_cast<int>(row.code), row.meaning);
    }
}

void print_kinds(Severity severity) {
    fmt::print("| code | exit | meaning | try |\n|---|---:|---|---|\n");
    for (const IssueKind& kind : posepack::base::issue_kinds()) {
        if (kind.severity != severity) continue;
        fmt::print("| `{}` | {} | {} | {} |\n", kind.id, static_cast<int>(kind.exit_code), kind.meaning,
                   kind.advice);
    }
}

}  // namespace

int main() {
    print_introduction();
    print_exit_codes();
    fmt::print("\n## Errors\n\n");
    print_kinds(Severity::error);
    fmt::print("\n## Warnings\n\n");
    print_kinds(Severity::warning);
}
