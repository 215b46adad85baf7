// m508 disasm: a stream or a recording as text.

#include "commands.h"
#include "input.h"

#include <halftone/file/write.h>
#include <halftone/protocol/text.h>
#include <halftone/recording/text.h>
#include <halftone/terminal/output_file.h>

#include <iostream>
#include <memory>
#include <span>
#include <string>

namespace halftone::m508 {

namespace {

struct Options {
  std::string file;
  std::string output; ///< empty: stdout
  bool replies = false;
};

std::string text_of(const Options& options) {
  const recording::Trace trace = read_trace(options.file);
  if (!options.replies) return recording::disassemble(trace);
  if (!trace.raw) throw ArgumentError("--replies: a recording holds commands; replies come as raw streams");
  return protocol::disassemble(data_of(trace), protocol::Direction::to_host);
}

ExitCode run(const Options& options) {
  check_files({{"-o", options.output}}, {options.file});
  const std::string text = text_of(options);
  if (options.output.empty()) {
    std::cout << text;
    return ExitCode::done;
  }
  const terminal::SignalShelter shelter;
  file::write_whole(options.output, std::as_bytes(std::span(text)));
  return ExitCode::done;
}

} // namespace

Command add_disasm(Arguments program) {
  Arguments command = program.add_subcommand("disasm", "Write a recording or a stream of commands as text");
  const auto options = std::make_shared<Options>();
  command.add_option("FILE", options->file, "Recording (.m508) or raw stream, - for standard input")
      .required()
      .type_name("");
  command.add_option("-o,--output", options->output, "Text file; standard output if left out")
      .type_name("OUT.txt");
  command.add_flag("--replies", options->replies, "The stream is what a device answered");
  command.footer("The text loses nothing: m508 asm makes the same bytes of it (docs/text-form.md).\n\n"
                 "Example:\n  m508 disasm session.m508 -o session.txt");
  return {command, [options] { return run(*options); }};
}

} // namespace halftone::m508
