#include <halftone/terminal/exit_code.h>

#include <halftone/core/error.h>
#include <halftone/link/link.h>
#include <halftone/png/png.h>
#include <halftone/protocol/words.h>
#include <halftone/recording/read.h>

#include <exception>

namespace halftone::terminal {

ExitCode guarded(std::string_view program, const std::function<ExitCode()>& command, std::ostream& errors) {
  const auto complain = [&](const std::exception& error, ExitCode code) {
    errors << program << ": " << error.what() << '\n';
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
  } catch (const png::WriteError& error) {
    return complain(error, ExitCode::no_output);
  } catch (const link::DeviceError& error) {
    return complain(error, ExitCode::device);
  } catch (const link::Timeout& error) {
    return complain(error, ExitCode::timeout);
  }
}

} // namespace halftone::terminal
