#include "core/base/number_text.h"

#include <array>
#include <cstdio>

namespace bosk {

std::string number_text(double number, int digits) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.*f", digits, number);
  return text.data();
}

std::string size_text(std::size_t bytes) {
  const double size = double(bytes);
  if (size < 1024.0 * 1024.0) return number_text(size / 1024.0, 1) + " KiB";
  return number_text(size / (1024.0 * 1024.0), 2) + " MiB";
}

}  // namespace bosk
