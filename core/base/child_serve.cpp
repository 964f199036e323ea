#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <locale>
#include <new>
#include <optional>
#include <span>
#include <sstream>

#include "core/base/child_protocol.h"
#include "core/base/error.h"

namespace bosk {
namespace {

// The address sanitizer reserves terabytes of addresses, so no limit on them can hold under it.
#ifdef __SANITIZE_ADDRESS__
constexpr bool kLimitAddresses = false;
#else
constexpr bool kLimitAddresses = true;
#endif

void limit(__rlimit_resource resource, rlim_t soft, rlim_t hard) {
  const rlimit wanted{soft, hard};
  ::setrlimit(resource, &wanted);  // fails only where a limit from outside is lower already
}

rlim_t whole_seconds(double cpu_s) { return rlim_t(std::max(1.0, std::ceil(cpu_s))); }

struct Settings {
  std::uint64_t memory_bytes = 0;
  double cpu_s = 0.0;
  pid_t parent = 0;
};

std::optional<Settings> parse(const std::string& text) {
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  Settings settings;
  if (!(stream >> settings.memory_bytes >> settings.cpu_s >> settings.parent)) return std::nullopt;
  return settings;
}

// No files (a pipe is none), no core dumps, bounded memory and time, and an end with the parent's.
bool enter(const Settings& settings) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != settings.parent) return false;
  limit(RLIMIT_CORE, 0, 0);
  limit(RLIMIT_FSIZE, 0, 0);
  limit(RLIMIT_CPU, whole_seconds(settings.cpu_s), whole_seconds(settings.cpu_s) + 1);
  if (kLimitAddresses) limit(RLIMIT_AS, settings.memory_bytes, settings.memory_bytes);
  return true;
}

bool send(std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(kChildPipe, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes = bytes.subspan(std::size_t(written));
  }
  return true;
}

int send_message(bool is_result, std::span<const std::byte> body) {
  const ChildMessage message{kChildMagic, is_result ? 1u : 0u, body.size()};
  return send(std::as_bytes(std::span(&message, 1))) && send(body) ? 0 : 1;
}

int refuse(const std::string& reason) {
  const auto bytes = std::as_bytes(std::span(reason.data(), reason.size()));
  return send_message(false, bytes.first(std::min<std::size_t>(bytes.size(), kMaxReasonBytes)));
}

}  // namespace

std::string child_settings_text(const ChildLimits& limits, pid_t parent) {
  std::ostringstream stream;
  stream.imbue(std::locale::classic());
  stream << limits.memory_bytes << ' ' << limits.cpu_s << ' ' << parent;
  return stream.str();
}

int serve_as_child(int argc, char** argv, ChildWork work) {
  const auto settings = argc >= 3 ? parse(argv[2]) : std::nullopt;
  if (!settings || !enter(*settings)) return 2;
  try {
    const std::vector<std::byte> result = work({argv + 3, argv + argc});
    return send_message(true, result);
  } catch (const std::bad_alloc&) {
    return refuse("more memory is needed than it may use");
  } catch (const std::exception& error) {
    return refuse(error.what());
  }
}

void set_child_cpu_limit(double cpu_s) {
  rlimit now{};
  if (::getrlimit(RLIMIT_CPU, &now) != 0) return;
  limit(RLIMIT_CPU, std::min(whole_seconds(cpu_s), now.rlim_max - 1), now.rlim_max);
}

}  // namespace bosk
