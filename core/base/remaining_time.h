#pragma once

#include <optional>
#include <string>

namespace bosk {

// How long a job goes on, told honestly: not before the job is under way, counting down by itself,
// and turning to a new estimate within a few seconds rather than at once.
class RemainingTime {
 public:
  // `fraction` of the job, 0 to 1, is done after `spent_s` seconds; calls in the order of time.
  // None before a twentieth of the job and 3 seconds have passed.
  std::optional<double> update(double fraction, double spent_s);

 private:
  double left_s_ = -1.0, told_s_ = 0.0;
};

// "2:05", minutes and seconds.
std::string minutes_text(double seconds);

}  // namespace bosk
