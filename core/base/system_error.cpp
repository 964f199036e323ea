#include "core/base/system_error.h"

#include <algorithm>
#include <cerrno>
#include <system_error>

namespace bosk {
namespace {

struct Diagnosis {
  ErrorKind kind;
  const char* remedy;
};

Diagnosis diagnose(int code) {
  switch (code) {
    case ENOSPC:
    case EDQUOT:
      return {ErrorKind::resource, "free space on this disk or choose a folder on another one"};
    case EFBIG:
      return {ErrorKind::resource, "raise the limit on file sizes (ulimit -f)"};
    case ENOMEM:
      return {ErrorKind::resource, "close other programs or use a machine with more memory"};
    case EMFILE:
    case ENFILE:
      return {ErrorKind::resource, "raise the limit on open files (ulimit -n)"};
    case EACCES:
    case EPERM:
      return {ErrorKind::bad_input, "change its permissions or choose another folder"};
    case EROFS:
      return {ErrorKind::bad_input, "the folder is read-only: choose another one"};
    case ENOENT:
    case ENOTDIR:
      return {ErrorKind::bad_input, "check the path"};
    case ENAMETOOLONG:
      return {ErrorKind::bad_input, "choose a shorter name"};
    case EISDIR:
      return {ErrorKind::bad_input, "it is a folder: give a file"};
    default:
      return {ErrorKind::temporary, "check the disk and try again"};
  }
}

}  // namespace

Error system_error(const std::filesystem::path& path, const std::string& doing, int code) {
  const Diagnosis diagnosis = diagnose(code);
  return Error(printable(path.string()) + ": cannot be " + doing + ": " +
                   std::generic_category().message(code) + "; " + diagnosis.remedy,
               diagnosis.kind);
}

std::string printable(const std::string& text) {
  std::string shown = text;
  std::replace_if(
      shown.begin(), shown.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, '?');
  return shown;
}

}  // namespace bosk
