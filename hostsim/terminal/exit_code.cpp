#include <halftone/terminal/exit_code.h>

#include <halftone/core/error.h>
#include <halftone/display/display.h>
#include <halftone/file/write.h>
#include <halftone/link/link.h>
#include <halftone/png/png.h>
#include <halftone/protocol/words.h>
#include <halftone/recording/read.h>

#include <algorithm>
#include <cctype>
#include <exception>
#include <new>
#include <system_error>

namespace halftone::terminal {

std::string one_line(std::string_view text) {
  std::string line(text);
  std::ranges::replace_if(
      line, [](char c) { return std::iscntrl(static_cast<unsigned char>(c)) != 0; }, '?');
  return line;
}

ExitCode guarded(std::string_view program, const std::function<ExitCode()>& command, std::ostream& errors) {
  const auto complain = [&](const std::exception& error, ExitCode code) {
    errors << program << ": " << one_line(error.what()) << '\n';
    return code;
  };
  try {
    return command();
  } catch (const ArgumentError& error) {
    return complain(error, ExitCode::bad_arguments);
  } catch (const core::InputError& error) {
    return complain(error, ExitCode::bad_input);
  } catch (const png::ReadError& error) {
    return complain(error, ExitCode::bad_input);
  } catch (const protocol::TextError& error) {
    return complain(error, ExitCode::bad_input);
  } catch (const recording::TraceError& error) {
    return complain(error, ExitCode::bad_input);
  } catch (const OutputError& error) {
    return complain(error, ExitCode::no_output);
  } catch (const file::WriteError& error) {
    return complain(error, ExitCode::no_output);
  } catch (const display::DisplayError& error) {
    return complain(error, ExitCode::no_output);
  } catch (const link::DeviceError& error) {
    return complain(error, ExitCode::device);
  } catch (const link::Timeout& error) {
    return complain(error, ExitCode::timeout);
  } catch (const std::bad_alloc&) {
    return complain(std::runtime_error("there is not enough memory for this; make the input smaller"),
                    ExitCode::bad_input);
  } catch (const std::system_error& error) { // a thread that cannot be started
    return complain(error, ExitCode::bad_input);
  }
}

} // namespace halftone::terminal
