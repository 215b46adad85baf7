// POV-Ray 3.7 as a process, on the exported scene, over its two methods of anti-aliasing. Its time is the one
// it reports for tracing: it starts up and parses apart.

#include "contender.h"
#include "shell.h"

#include <halftone/convert/povray.h>
#include <halftone/file/write.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <span>
#include <sstream>
#include <stdexcept>
#include <string>

namespace halftone::bench {

namespace {

namespace fs = std::filesystem;

struct NamedSettings {
  std::string name;
  std::string options;
};

std::string contents(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// A PPM of 16 bits with linear samples, as radiance from 0 to 1.
struct Linear {
  int width = 0;
  int height = 0;
  std::vector<float> rgb;
};

Linear read_ppm(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  const auto word = [&] {
    std::string text;
    while (in >> text && text.starts_with('#')) in.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
    return text;
  };
  const auto whole = [&] {
    const std::string text = word();
    return std::atoi(text.c_str());
  };
  const std::string magic = word();
  Linear picture;
  picture.width = whole();
  picture.height = whole();
  const int most = whole();
  in.get();
  if (!in || magic != "P6" || most != 65535)
    throw std::runtime_error(file.string() + ": POV-Ray wrote no 16-bit PPM");
  const auto samples = 3 * static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
  std::vector<unsigned char> bytes(2 * samples);
  in.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  if (!in) throw std::runtime_error(file.string() + ": cut short");
  picture.rgb.resize(samples);
  for (std::size_t i = 0; i < samples; ++i)
    picture.rgb[i] = static_cast<float>(bytes[2 * i] * 256 + bytes[2 * i + 1]) / 65535.0F;
  return picture;
}

/// The mean of factor x factor pixels each, in levels. POV-Ray's picture is exposed already.
Levels reduced(const Linear& picture, int factor, scene::Image image) {
  if (picture.width != image.width * factor || picture.height != image.height * factor)
    throw std::runtime_error("POV-Ray's picture has another size than was asked for");
  image.exposure = 1;
  Levels levels = empty_levels(image);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      core::Color sum{0};
      for (int j = 0; j < factor; ++j)
        for (int i = 0; i < factor; ++i)
          for (int c = 0; c < 3; ++c)
            sum[c] += static_cast<double>(picture.rgb[3 * (static_cast<std::size_t>(y * factor + j) *
                                                               static_cast<std::size_t>(picture.width) +
                                                           static_cast<std::size_t>(x * factor + i)) +
                                                      static_cast<std::size_t>(c)]);
      set_pixel(levels, x, y, sum / static_cast<double>(factor * factor), image);
    }
  return levels;
}

/// "Trace Time:  0 hours  0 minutes  0 seconds (0.068 seconds)".
double trace_seconds(const std::string& log) {
  const std::size_t line = log.find("Trace Time:"), bracket = log.find('(', line);
  if (line == std::string::npos || bracket == std::string::npos)
    throw std::runtime_error("POV-Ray did not tell its trace time:\n" + log);
  return std::stod(log.substr(bracket + 1));
}

class PovRay : public Contender {
public:
  PovRay(std::string name, std::string title, std::vector<NamedSettings> all, int threads)
      : name_(std::move(name)),
        title_(std::move(title)),
        all_(std::move(all)),
        threads_(threads) {}

  std::string name() const override { return name_; }
  std::string title() const override { return title_; }
  std::vector<std::string> settings() const override {
    std::vector<std::string> names;
    for (const NamedSettings& each : all_) names.push_back(each.name);
    return names;
  }
  Drawn draw(const Subject& subject, std::size_t setting) override {
    return run(subject, all_[setting].options, 1);
  }
  /// 8 x 8 pixels for each, with 3 x 3 samples in every one of them.
  Levels converged(const Subject& subject) override { return run(subject, "+AM1 +A0.0 +R3 -J", 8).levels; }

private:
  Drawn run(const Subject& subject, const std::string& options, int factor) const {
    const fs::path scene = subject.folder / "scene.pov", picture = subject.folder / "povray.ppm",
                   log = subject.folder / "povray.log";
    const std::string text = convert::povray(subject.scene);
    file::write_whole(scene, std::as_bytes(std::span(text)));
    std::ostringstream command;
    command << "cd " << in_shell_quotes(subject.folder.string())
            << " && povray +Iscene.pov +Opovray.ppm +FP16"
            << " File_Gamma=1.0 -D -V +W" << subject.scene.image.width * factor << " +H"
            << subject.scene.image.height * factor << " +WT" << threads_ << ' ' << options
            << " >povray.log 2>&1";
    if (std::system(command.str().c_str()) != 0)
      throw std::runtime_error("POV-Ray failed:\n" + contents(log));
    Drawn drawn{reduced(read_ppm(picture), factor, subject.scene.image), trace_seconds(contents(log))};
    fs::remove(picture);
    return drawn;
  }

  std::string name_;
  std::string title_;
  std::vector<NamedSettings> all_;
  int threads_;
};

} // namespace

void add_povray(Contenders& contenders, int threads, std::vector<std::string>& missing) {
  if (std::system("povray --version >/dev/null 2>&1") != 0) {
    missing.push_back("POV-Ray 3.7 is not installed (Debian: povray)");
    return;
  }
  const auto with_options = [](std::vector<std::string> all) {
    std::vector<NamedSettings> named;
    for (const std::string& options : all) named.push_back({options, options + " -J"});
    return named;
  };
  contenders.push_back(
      std::make_unique<PovRay>("povray-1", "POV-Ray 3.7, method 1",
                               with_options({"-A", "+AM1 +A0.3 +R2", "+AM1 +A0.1 +R3", "+AM1 +A0.03 +R4",
                                             "+AM1 +A0.0 +R4", "+AM1 +A0.0 +R6", "+AM1 +A0.0 +R9"}),
                               threads));
  contenders.push_back(
      std::make_unique<PovRay>("povray-2", "POV-Ray 3.7, method 2",
                               with_options({"-A", "+AM2 +A0.3 +R2", "+AM2 +A0.1 +R3", "+AM2 +A0.03 +R3",
                                             "+AM2 +A0.01 +R4", "+AM2 +A0.003 +R4", "+AM2 +A0.001 +R5"}),
                               threads));
}

} // namespace halftone::bench
