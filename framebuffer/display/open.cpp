#include <halftone/display/open.h>

#include <halftone/display/module.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <system_error>

#include <dlfcn.h>

namespace halftone::display {

namespace fs = std::filesystem;

namespace {

struct Known {
  std::string_view name;
  std::string_view to_build; ///< Debian packages
  std::string_view to_run;
};

constexpr std::array known{
    Known{"window", "libsdl2-dev", "libsdl2-2.0-0"},
    Known{"vnc", "libvncserver-dev", "libvncserver1"},
    Known{"web", "libvncserver-dev", "libvncserver1 novnc websockify"},
};

fs::path find(const std::string& file, const std::vector<fs::path>& folders) {
  for (const fs::path& folder : folders) {
    std::error_code none;
    if (fs::exists(folder / file, none)) return folder / file;
  }
  return {};
}

/// What the system says of the last dlopen or dlsym that failed.
std::string failure() {
  const char* const text = ::dlerror();
  return text == nullptr ? "no reason was given" : text;
}

} // namespace

std::vector<std::string> names() {
  std::vector<std::string> names;
  for (const Known& each : known) names.emplace_back(each.name);
  return names;
}

Choice parse_choice(std::string_view text) {
  const std::size_t colon = std::min(text.find(':'), text.size());
  Choice choice{std::string(text.substr(0, colon)),
                std::string(text.substr(std::min(colon + 1, text.size())))};
  if (std::ranges::find(known, choice.name, &Known::name) != known.end()) return choice;
  std::string all;
  for (const Known& each : known) all += (all.empty() ? "" : ", ") + std::string(each.name);
  throw std::invalid_argument("there is no display \"" + choice.name + "\"; there are " + all);
}

std::unique_ptr<Display> open(const Choice& choice, const std::vector<fs::path>& folders) {
  const auto display = std::ranges::find(known, choice.name, &Known::name);
  if (display == known.end()) throw std::invalid_argument("there is no display \"" + choice.name + '"');
  const std::string who = "display " + choice.name + ": ";

  const std::string file = "halftone-display-" + choice.name + ".so";
  const fs::path module = find(file, folders);
  if (module.empty())
    throw DisplayError(who + "this build has no " + file + "; install " + std::string(display->to_build) +
                       " and build again");
  // Now, not when a function is first called: what is missing has to be said before anything is shown.
  void* const handle = ::dlopen(module.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr)
    throw DisplayError(who + failure() + "; the packages needed are: " + std::string(display->to_run));
  auto* const open_display = reinterpret_cast<OpenFunction*>(::dlsym(handle, open_function));
  if (open_display == nullptr)
    throw DisplayError(who + module.string() + " is of another version: " + failure());
  return std::unique_ptr<Display>(open_display(choice.where.c_str()));
}

std::vector<fs::path> module_folders() {
  std::error_code none;
  const fs::path program = fs::read_symlink("/proc/self/exe", none).parent_path();
  return {program, program / HALFTONE_INSTALLED_MODULES};
}

} // namespace halftone::display
