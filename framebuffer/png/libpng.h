#pragma once
// libpng's way of failing, tamed. It leaves through longjmp, which must not pass over C++ objects with
// destructors; so its calls are made inside `succeeds`, in steps that have no such objects, and everything
// that owns something lives outside.

#include <png.h>

#include <csetjmp>
#include <cstdio>
#include <memory>

namespace halftone::png {

/// libpng's message, kept where longjmp cannot harm it.
struct ErrorText {
  char text[200] = "";
};

[[noreturn]] inline void on_error(png_structp png, png_const_charp message) {
  auto* const error = static_cast<ErrorText*>(png_get_error_ptr(png));
  std::snprintf(error->text, sizeof error->text, "%s", message);
  png_longjmp(png, 1);
}

inline void on_warning(png_structp, png_const_charp) {}

/// Runs a step of calls to libpng; false if one of them failed. The step may create nothing that has a
/// destructor, nor may a caller rely on variables that the step changed before it failed.
template<class Step>
bool succeeds(png_structp png, const Step& step) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  step();
  return true;
}

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

} // namespace halftone::png
