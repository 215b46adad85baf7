#include "program.h"

#include <halftone/png/png.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

using halftone::test::Bench;
using halftone::test::contents;
using halftone::test::Outcome;
namespace png = halftone::png;

namespace {

struct Painting : Bench {
  Painting() {
    stream("s.raw", "fill x=10 y=20 width=4 height=3 red=1 green=2 blue=3\nmark \"first\"\nzoom shift=1\n");
  }

  Outcome check(const std::string& checks, const std::vector<std::string>& options = {}) const {
    file("c.toml", checks);
    std::vector<std::string> arguments{"assert", "s.raw", "c.toml"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return m508(arguments);
  }
};

const std::string good = "[[check]]\nname = \"all is blue\"\nat = \"first\"\nrectangle = [10, 20, 4, 3]\n"
                         "color = [1, 2, 3]\n";
const std::string bad = "[[check]]\nname = \"a <black> & \\\"white\\\" pixel\"\npixel = [10, 20]\n"
                        "plane = \"image0\"\ncolor = [0, 0, 0]\n";

} // namespace

TEST_CASE("assert tells of each check whether it holds") {
  const Painting painting;
  const Outcome all_good = painting.check(good);
  CHECK(all_good.exit_code == 0);
  CHECK(all_good.out == "ok    all is blue\n1 of 1 check holds\n");
  const Outcome one_bad =
      painting.check(good + "[[check]]\npixel = [10, 20]\nplane = \"image0\"\ncolor = [0, 0, 0]\n");
  CHECK(one_bad.exit_code == 1);
  CHECK(one_bad.out == "ok    all is blue\n"
                       "FAIL  check 2: pixel (10, 20): found 1 2 3, expected 0 0 0 (after command 3)\n"
                       "1 of 2 checks hold\n");
}

TEST_CASE("assert knows all kinds of expectations") {
  const Outcome outcome =
      Painting().check(good + "[[check]]\nchecksum = 0\n"
                              "[[check]]\nregisters = { zoom = 1, window = [0, 0, 512, 512] }\n"
                              "[[check]]\nat = 1\ncounts = { errors = 0, commands = 1, fill = 1 }\n"
                              "[[check]]\nlut = { channel = \"blue\", first = 254, values = [254, 255] }\n"
                              "[[check]]\nplane = \"overlay\"\npixel = [0, 0]\ncolor = 0\n");
  CHECK(outcome.exit_code == 1);
  CHECK(outcome.out.find("FAIL  check 2: checksum of 512 x 512 at (0, 0): found 0x") != std::string::npos);
  CHECK(outcome.out.ends_with("5 of 6 checks hold\n"));
}

TEST_CASE("assert compares with pictures beside the file, and writes the differences") {
  const Painting painting;
  png::Picture picture{4, 3, {}};
  for (int i = 0; i < 12; ++i) picture.rgb.insert(picture.rgb.end(), {1, 2, 3});
  picture.rgb[0] = 5;
  png::write(painting.scratch / "p.png", picture, png::Encoding::srgb);
  const std::string check = "[[check]]\nplane = \"image0\"\nrectangle = [10, 20, 4, 3]\nimage = \"p.png\"\n";
  const Outcome outcome = painting.check(check, {"--diff", "d.png"});
  CHECK(outcome.exit_code == 1);
  CHECK(outcome.out.find(
            "farthest apart is pixel (10, 20): found 1 2 3, expected 5 2 3; 1 of 12 pixels differ") !=
        std::string::npos);
  CHECK(png::read(painting.scratch / "d.png").rgb[0] == 128 - 8 * 4);
  CHECK(painting.check(check + "max_difference = 4\n", {"--diff", "none.png"}).exit_code == 0);
  CHECK(contents(painting.scratch / "none.png") == "(no such file)");
  const Outcome wrong_size = painting.check("[[check]]\nimage = \"p.png\"\n");
  CHECK(wrong_size.exit_code == 3);
  CHECK(wrong_size.err ==
        "m508: c.toml:2:9: the image has 4 x 3 pixels, and what it is compared with 512 x 512; "
        "say where it lies, as in rectangle = [x, y, 4, 3]\n");
}

TEST_CASE("assert writes JUnit XML that a parser takes") {
  const Painting painting;
  CHECK(painting.check(good + bad, {"--junit", "r.xml"}).exit_code == 1);
  const std::string xml = contents(painting.scratch / "r.xml");
  CHECK(xml.find("<testsuite name=\"s.raw\" tests=\"2\" failures=\"1\" errors=\"0\">") != std::string::npos);
  CHECK(xml.find("name=\"a &lt;black&gt; &amp; &quot;white&quot; pixel\"") != std::string::npos);
  const std::string script = painting.scratch.write(
      "parse.py",
      "import sys, xml.etree.ElementTree as tree\n"
      "suite = tree.parse(sys.argv[1]).getroot().find('testsuite')\n"
      "cases = suite.findall('testcase')\n"
      "failed = [case for case in cases if case.find('failure') is not None]\n"
      "assert len(cases) == 2 and len(failed) == 1\n"
      "assert failed[0].find('failure').get('message').startswith('pixel (10, 20): found 1 2 3')\n");
  const std::string call = "python3 '" + script + "' '" + painting.scratch / "r.xml" + "'";
  CHECK(std::system(call.c_str()) == 0);
}

TEST_CASE("a message with control characters, which XML has no place for, is told in XML without them") {
  const Painting painting;
  CHECK(
      painting.check("[[check]]\nat = \"m\\u0000\\u0001\"\nchecksum = 1\n", {"--junit", "r.xml"}).exit_code ==
      1);
  CHECK(contents(painting.scratch / "r.xml").find("the recording has no mark &quot;m??&quot;") !=
        std::string::npos);
}

TEST_CASE("mistakes in a file of checks are told with line, column and advice") {
  const std::vector<std::pair<std::string, std::string>> mistakes{
      {"[[check]]\npixle = [1, 2]\n", ":2:1: unknown key \"pixle\" in check; the keys are name, at, "},
      {"[check]\npixel = [1, 2]\n", ": there is no check in it; begin one with [[check]]"},
      {"", ": there is no check in it; begin one with [[check]]"},
      {"checks = 1\n", ":1:1: unknown key \"checks\" in the file; the keys are check"},
      {"[[check]]\npixel = [1, 2]\n",
       ":1:1: a check that expects nothing; it needs one of color, checksum, "},
      {"[[check]]\npixel = [1, 512]\ncolor = [1, 2, 3]\n",
       ":2:13: pixel: expected an integer from 0 to 511, found 512"},
      {"[[check]]\npixel = [1, 2]\ncolor = [1, 2]\n",
       ":3:9: color: expected an array of 3 integers, found 2"},
      {"[[check]]\npixel = [1, 2]\ncolor = \"red\"\n",
       ":3:9: color: expected an array of 3 integers, found text"},
      {"[[check]]\npixel = [1, 2]\ncolor = [1.5, 2, 3]\n",
       ":3:10: color: expected an integer from 0 to 255, found a number with a point"},
      {"[[check]]\ncolor = [1, 2, 3]\n",
       ":1:1: a check of a color needs pixel or rectangle; as in pixel = [10, 20]"},
      {"[[check]]\nrectangle = [500, 0, 20, 1]\nchecksum = 1\n",
       ":2:13: the rectangle reaches beyond the screen"},
      {"[[check]]\npixel = [1, 2]\ncolor = [1, 2, 3]\nchecksum = 1\n",
       ":4:12: a check with both color and checksum; make two"},
      {"[[check]]\nregisters = { zom = 1 }\n", ":2:21: unknown register \"zom\"; the registers are window, "},
      {"[[check]]\ncounts = { fils = 1 }\n", ":2:19: unknown count \"fils\"; "},
      {"[[check]]\nlut = { channel = \"rot\", values = [1] }\n",
       ":2:19: unknown channel; it is red, green or blue"},
      {"[[check]]\nlut = { channel = \"red\", first = 255, values = [1, 2] }\n",
       ": values: expected an array of 1 to 1 integers"},
      {"[[check]]\nplane = \"image2\"\nchecksum = 1\n", ":2:9: unknown plane \"image2\"; it is screen, "},
      {"[[check]]\nat = 1.5\nchecksum = 1\n",
       ":2:6: at: expected \"end\", the number of a command or the name of a mark"},
      {"[[check]]\nchecksum = 1\nmax_rmse = 1\n",
       ":3:12: max_rmse means nothing without image; leave it out"},
      {"[[check]]\nname = \"a\"\nchecksum = 1\n[[check]]\nname = \"a\"\nchecksum = 1\n",
       ":4:1: a second check \"a\"; "},
      {"[[check]]\nregisters = {}\n",
       ":2:13: registers: an empty table holds whatever the recording does; say "},
      {"[[check]]\ncounts = {}\n", ":2:10: counts: an empty table holds whatever the recording does; say "},
      {"[[check]]\nname = \"a\\u0000b\"\nchecksum = 1\n",
       ":2:8: name: character 2 is a control character, of code 0; use letters"},
      {"[[check]]\nname = \"two\\nlines\"\nchecksum = 1\n",
       ":2:8: name: character 4 is a control character, of code 10; use letters"},
      {"[[check]]\nname = \"\\u007f\"\nchecksum = 1\n",
       ":2:8: name: character 1 is a control character, of code 127; use letters"},
      {"[[check]]\nchecksum = \n", ": not valid TOML: "},
      {"[[check]]\nimage = \"p.png\"\n", "p.png: "},
  };
  const Painting painting;
  for (const auto& [checks, message] : mistakes) {
    const Outcome outcome = painting.check(checks, {"--junit", "r.xml"});
    INFO(checks << outcome.err);
    CHECK(outcome.exit_code == 3);
    CHECK(outcome.out.empty());
    CHECK(outcome.err.find(message) != std::string::npos);
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
  }
  std::string deep = "a";
  for (int i = 0; i < 30000; ++i) deep += ".a";
  CHECK(painting.check(deep + " = 1\n").exit_code == 3);
  CHECK(contents(painting.scratch / "r.xml") == "(no such file)");
}

TEST_CASE("assert --json prints the documented keys") {
  const Outcome outcome = Painting().check(good + bad, {"--json"});
  CHECK(outcome.exit_code == 1);
  CHECK(halftone::test::keys_of(outcome.out) == halftone::test::documented("m508 assert"));
}

TEST_CASE("assert does not write over what it reads or writes, nor into folders that are not there") {
  const Painting painting;
  png::Picture picture{512, 512, std::vector<std::uint8_t>(std::size_t{512} * 512 * 3)};
  png::write(painting.scratch / "p.png", picture, png::Encoding::srgb);
  const auto picture_before = contents(painting.scratch / "p.png");
  const std::string check = "[[check]]\nimage = \"p.png\"\n";
  const auto refused = [&](const std::vector<std::string>& options, const std::string& message) {
    const Outcome outcome = painting.check(check, options);
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.err == "m508: " + message + ", which would be lost\n");
  };
  refused({"--junit", "c.toml"}, "--junit c.toml: is an input");
  refused({"--diff", "s.raw"}, "--diff s.raw: is an input");
  refused({"--diff", "p.png"}, "--diff p.png: is an input");
  refused({"--junit", "./p.png"}, "--junit ./p.png: is an input");
  refused({"--diff", "d.png", "--junit", "./d.png"}, "--junit ./d.png: is what --diff writes");
  CHECK((contents(painting.scratch / "p.png") == picture_before));
  CHECK(contents(painting.scratch / "d.png") == "(no such file)");
  CHECK(painting.check(good, {"--junit", "missing/r.xml"}).exit_code == 4);
}
