// SPDX-License-Identifier: MIT
// Issue: what went wrong, where, what was expected and found. One table names every kind.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace posepack::base {

// Exit codes of the program; documented in docs/issues.md.
enum class ExitCode : int {
    ok = 0,
    usage = 1,
    io = 2,
    malformed_glb = 3,
    malformed_catalog = 4,
    unsupported = 5,
    limit = 6,
    bad_container = 7,
    mismatch = 8,
    partial = 9,
    internal = 70,
    interrupted = 130,
};

enum class Severity { warning, error };

// One enumerator per row of issue_table.def; the id in messages is the row's text.
enum class IssueCode {
#define POSEPACK_ISSUE(name, id, severity, exit_code, meaning, advice) name,
#include "base/issue_table.def"
#undef POSEPACK_ISSUE
};

// A row of the table.
struct IssueKind {
    IssueCode code;
    std::string_view id;  // "E-GLB-MAGIC"
    Severity severity;
    ExitCode exit_code;        // of the program when this issue ends it; ok for warnings
    std::string_view meaning;  // one sentence for the documentation
    std::string_view advice;   // what to try: ends the message
};

// A finding about an input. `where` is a path inside the input ("deer.glb: accessors/12"); `detail` says
// what was expected and what was found.
struct Issue {
    IssueCode code{};
    std::string where;
    std::string detail;
};

// The row that describes `code`.
const IssueKind& issue_kind(IssueCode code);

// Every row, in the order of the table.
std::span<const IssueKind> issue_kinds();

// One line without newline: "error[E-GLB-MAGIC]: deer.glb: expected ..., found ...; try: ...".
// Control characters and invalid UTF-8 of the input are escaped; input text is cut at 256 bytes.
std::string format_issue(const Issue& issue);

// The same as one line of JSON: {"code", "severity", "where", "detail", "advice", "exit_code"}.
std::string format_issue_json(const Issue& issue);

// Puts `prefix` and ": " before the issue's place.
Issue at(std::string_view prefix, Issue issue);

}  // namespace posepack::base
