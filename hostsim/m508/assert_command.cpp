// m508 assert: whether a recording does what it should.

#include "commands.h"

#include "checks_file.h"
#include "input.h"
#include "junit.h"
#include "told.h"

#include <halftone/file/write.h>
#include <halftone/inspect/check.h>
#include <halftone/png/png.h>
#include <halftone/terminal/output_file.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iostream>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace halftone::m508 {

namespace {

using inspect::Check;
using inspect::Verdict;

struct Options {
  std::string file;
  std::string checks;
  std::string difference; ///< empty: not asked for
  std::string junit;      ///< empty: not asked for
  bool json = false;
};

std::string for_people(const std::vector<Check>& checks, const std::vector<Verdict>& verdicts) {
  std::string text;
  for (std::size_t i = 0; i < verdicts.size(); ++i) {
    text += (verdicts[i].holds ? "ok    " : "FAIL  ") + checks[i].name;
    if (!verdicts[i].holds) text += ": " + verdicts[i].message;
    if (!verdicts[i].holds && verdicts[i].number)
      text += " (after command " + std::to_string(*verdicts[i].number) + ")";
    text += '\n';
  }
  const auto good = std::ranges::count(verdicts, true, &Verdict::holds);
  return text + std::to_string(good) + " of " + of_them(verdicts.size(), "check") +
         (verdicts.size() == 1 ? " holds\n" : " hold\n");
}

std::string as_json(const std::vector<Check>& checks, const std::vector<Verdict>& verdicts) {
  using Json = nlohmann::ordered_json;
  Json list = Json::array();
  for (std::size_t i = 0; i < verdicts.size(); ++i)
    list.push_back({{"name", checks[i].name},
                    {"holds", verdicts[i].holds},
                    {"after_command", verdicts[i].number ? Json(*verdicts[i].number) : Json()},
                    {"message", verdicts[i].holds ? Json() : Json(verdicts[i].message)}});
  const auto failures = std::ranges::count(verdicts, false, &Verdict::holds);
  return Json({{"checks", verdicts.size()}, {"failures", failures}, {"verdicts", list}}).dump(2) + "\n";
}

/// Of the first image that does not hold; nothing is written where there is none.
void write_difference(const Options& options, const std::vector<Verdict>& verdicts) {
  const auto found =
      std::ranges::find_if(verdicts, [](const Verdict& verdict) { return verdict.difference.has_value(); });
  if (options.difference.empty() || found == verdicts.end()) return;
  png::write(options.difference, *found->difference, png::Encoding::srgb);
}

ExitCode run(const Options& options) {
  const std::vector<terminal::Output> outputs{{"--diff", options.difference}, {"--junit", options.junit}};
  check_files(outputs, {options.file, options.checks});
  const auto [checks, pictures] = read_checks(options.checks);
  check_files(outputs, pictures);
  const std::vector<Verdict> verdicts = inspect::evaluate(read_trace(options.file), checks);
  {
    const terminal::SignalShelter shelter;
    write_difference(options, verdicts);
    if (!options.junit.empty()) {
      const std::string report = junit(options.file, checks, verdicts);
      file::write_whole(options.junit, std::as_bytes(std::span(report)));
    }
  }
  std::cout << (options.json ? as_json(checks, verdicts) : for_people(checks, verdicts));
  return std::ranges::all_of(verdicts, &Verdict::holds) ? ExitCode::done : ExitCode::no;
}

} // namespace

Command add_assert(Arguments program) {
  Arguments command = program.add_subcommand("assert", "Check what a recording has done to the device");
  const auto options = std::make_shared<Options>();
  command.add_option("FILE", options->file, "Recording or raw stream of commands, - for standard input")
      .required()
      .type_name("");
  command.add_option("CHECKS", options->checks, "What is expected (.toml, see docs/assert.md)")
      .required()
      .type_name("");
  command
      .add_option("--diff", options->difference,
                  "The differences of the first image that fails, 8 times as strong, around mid-grey")
      .type_name("OUT.png");
  command.add_option("--junit", options->junit, "The verdicts for continuous integration")
      .type_name("OUT.xml");
  command.add_flag("--json", options->json, "Print the verdicts as one JSON object");
  command.footer("A file of checks:\n"
                 "  [[check]]\n"
                 "  name = \"the sun is yellow\"\n"
                 "  at = \"end\"                # or the number of a command, or the name of a mark\n"
                 "  pixel = [12, 12]\n"
                 "  color = [255, 255, 0]\n\n"
                 "Exit code 1 if a check fails.\n\n"
                 "Example:\n  m508 assert session.m508 checks.toml --junit report.xml");
  return {command, [options] { return run(*options); }};
}

} // namespace halftone::m508
