#pragma once

#include <cstddef>
#include <string>

namespace bosk {

// Fixed digits after the point.
std::string number_text(double number, int digits);
// "2.3 MiB"
std::string size_text(std::size_t bytes);

}  // namespace bosk
