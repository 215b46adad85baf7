// m508 lint: what in a stream is likely a mistake, or a waste.

#include "commands.h"

#include "input.h"
#include "told.h"

#include <halftone/inspect/lint.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iostream>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace halftone::m508 {

namespace {

using inspect::Finding;
using inspect::Severity;

struct Options {
  std::string file;
  bool json = false;
};

std::string_view name_of(Severity severity) { return severity == Severity::warning ? "warning" : "note"; }

std::uint64_t count_of(const std::vector<Finding>& findings, Severity severity) {
  return static_cast<std::uint64_t>(std::ranges::count(
      findings, severity, [](const Finding& finding) { return inspect::entry_of(finding.kind).severity; }));
}

std::string for_people(const Options& options, const std::vector<Finding>& findings) {
  std::string text;
  for (const Finding& finding : findings) {
    const inspect::KindEntry& kind = inspect::entry_of(finding.kind);
    text += options.file + ": command " + std::to_string(finding.command.number) + ": " +
            std::string(name_of(kind.severity)) + ": " + finding.command.text + ": " + finding.what;
    if (!finding.advice.empty()) text += "; " + finding.advice;
    text += " [" + std::string(kind.name) + "]\n";
  }
  if (findings.empty()) return "no findings\n";
  std::string kinds;
  for (const inspect::KindEntry& kind : inspect::kind_table) {
    const auto count = std::ranges::count(findings, kind.kind, &Finding::kind);
    if (count != 0)
      kinds += (kinds.empty() ? "" : ", ") + std::to_string(count) + ' ' + std::string(kind.name);
  }
  return text + of_them(count_of(findings, Severity::warning), "warning") + ", " +
         of_them(count_of(findings, Severity::note), "note") + ": " + kinds + '\n';
}

std::string as_json(const std::vector<Finding>& findings) {
  using Json = nlohmann::ordered_json;
  Json list = Json::array(), kinds = Json::array();
  for (const Finding& finding : findings) {
    const inspect::KindEntry& kind = inspect::entry_of(finding.kind);
    Json told = {{"kind", kind.name},
                 {"severity", name_of(kind.severity)},
                 {"what", finding.what},
                 {"advice", finding.advice}};
    told.update(json_of(finding.command));
    list.push_back(told);
  }
  for (const inspect::KindEntry& kind : inspect::kind_table)
    kinds.push_back({{"kind", kind.name},
                     {"severity", name_of(kind.severity)},
                     {"count", std::ranges::count(findings, kind.kind, &Finding::kind)}});
  const Json object = {{"warnings", count_of(findings, Severity::warning)},
                       {"notes", count_of(findings, Severity::note)},
                       {"kinds", kinds},
                       {"findings", list}};
  return object.dump(2) + "\n";
}

ExitCode run(const Options& options) {
  const std::vector<Finding> findings = inspect::lint(read_trace(options.file));
  std::cout << (options.json ? as_json(findings) : for_people(options, findings));
  return count_of(findings, Severity::warning) == 0 ? ExitCode::done : ExitCode::no;
}

std::string kinds() {
  std::string text = "Findings:\n";
  for (const inspect::KindEntry& kind : inspect::kind_table)
    text += "  " + std::string(kind.name) + " (" + std::string(name_of(kind.severity)) +
            "): " + std::string(kind.meaning) + '\n';
  return text;
}

} // namespace

Command add_lint(Arguments program) {
  Arguments command =
      program.add_subcommand("lint", "Find what is likely a mistake, or a waste, in a stream");
  const auto options = std::make_shared<Options>();
  command.add_option("FILE", options->file, "Recording or raw stream of commands, - for standard input")
      .required()
      .type_name("");
  command.add_flag("--json", options->json, "Print it as one JSON object");
  command.footer(kinds() + "Exit code 1 if there are warnings.\n\nExample:\n  m508 lint session.m508");
  return {command, [options] { return run(*options); }};
}

} // namespace halftone::m508
