// halftone compare: how far two pictures are apart.

#include "commands.h"
#include <halftone/terminal/limits.h>
#include <halftone/terminal/output_file.h>

#include <halftone/core/error.h>
#include <halftone/png/compare.h>
#include <halftone/png/png.h>

#include <nlohmann/json.hpp>

#include <iostream>
#include <memory>
#include <optional>
#include <sstream>
#include <string>

namespace halftone::cli {

namespace {

struct Options {
  std::string a;
  std::string b;
  std::string difference; ///< empty: not asked for
  std::optional<double> max_rmse;
  std::optional<double> max_difference;
  bool json = false;
};

std::string for_people(const png::Difference& difference) {
  std::ostringstream text;
  text << "rmse                " << difference.rmse << '\n';
  text << "largest difference  " << difference.largest;
  if (difference.largest > 0) text << " at (" << difference.largest_x << ", " << difference.largest_y << ")";
  text << '\n';
  text << "99.9th percentile   " << difference.percentile_999 << '\n';
  text << "over 1 level        " << 100 * difference.share_over_1 << " % of pixels\n";
  text << "over 4 levels       " << 100 * difference.share_over_4 << " % of pixels\n";
  text << "over 16 levels      " << 100 * difference.share_over_16 << " % of pixels\n";
  return text.str();
}

std::string as_json(const png::Difference& difference) {
  const nlohmann::ordered_json object = {
      {"rmse", difference.rmse},
      {"largest", difference.largest},
      {"largest_x", difference.largest_x},
      {"largest_y", difference.largest_y},
      {"percentile_999", difference.percentile_999},
      {"share_over_1", difference.share_over_1},
      {"share_over_4", difference.share_over_4},
      {"share_over_16", difference.share_over_16},
  };
  return object.dump(2) + "\n";
}

ExitCode run(const Options& options) {
  terminal::check_outputs({{"--diff", options.difference}}, {options.a, options.b});
  const png::Picture a = png::read(options.a), b = png::read(options.b);
  if (a.width != b.width || a.height != b.height) {
    std::ostringstream problem;
    problem << "is " << b.width << " x " << b.height << " pixels, but " << options.a << " is " << a.width
            << " x " << a.height;
    throw core::InputError({options.b}, problem.str());
  }

  const png::Difference difference = png::compare(a, b);
  if (!options.difference.empty()) {
    const terminal::SignalShelter shelter;
    png::write(options.difference, png::difference_picture(a, b), png::Encoding::srgb);
  }
  std::cout << (options.json ? as_json(difference) : for_people(difference));

  ExitCode result = ExitCode::done;
  if (options.max_rmse && difference.rmse > *options.max_rmse) {
    std::cerr << "halftone: rmse " << difference.rmse << " is over " << *options.max_rmse << '\n';
    result = ExitCode::no;
  }
  if (options.max_difference && difference.largest > *options.max_difference) {
    std::cerr << "halftone: largest difference " << difference.largest << " is over "
              << *options.max_difference << '\n';
    result = ExitCode::no;
  }
  return result;
}

} // namespace

Command add_compare(Arguments program) {
  Arguments command =
      program.add_subcommand("compare", "Measure the difference of two pictures, in 8-bit levels");
  const auto options = std::make_shared<Options>();
  command.add_option("A", options->a, "PNG file").required().type_name("");
  command.add_option("B", options->b, "PNG file of the same size").required().type_name("");
  command
      .add_option("--max-rmse", options->max_rmse,
                  "Exit code 1 where the root mean square error is over this")
      .check(terminal::zero_or_more())
      .type_name("LEVELS");
  command
      .add_option("--max-diff", options->max_difference,
                  "Exit code 1 where the largest difference is over this")
      .check(terminal::zero_or_more())
      .type_name("LEVELS");
  command
      .add_option("--diff", options->difference,
                  "The differences as a picture, 8 times as strong, around mid-grey")
      .type_name("OUT.png");
  command.add_flag("--json", options->json, "Print the numbers as one JSON object");
  command.footer("Example:\n  halftone compare fig9a.png tests/golden/fig9a.png --max-rmse 0.4");
  return {command, [options] { return run(*options); }};
}

} // namespace halftone::cli
