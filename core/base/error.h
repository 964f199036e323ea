#pragma once

#include <stdexcept>
#include <string>

namespace bosk {

// What went wrong, and so which exit status the command line gives (architecture: 3, 5, 75).
enum class ErrorKind {
  bad_input,  // a file, photo or value that the user can mend; trying again unchanged is useless
  resource,   // memory or disk ran out; trying again with more helps
  temporary,  // something outside failed for now; trying again later may help
};

// A failure that the user is told of. `what()` is one sentence that names the file, photo or value
// and the remedy; it is shown as it is. Our own mistakes are assertions, never an Error.
class Error : public std::runtime_error {
 public:
  explicit Error(const std::string& message, ErrorKind kind = ErrorKind::bad_input)
      : std::runtime_error(message), kind_(kind) {}
  ErrorKind kind() const { return kind_; }

 private:
  ErrorKind kind_;
};

}  // namespace bosk
