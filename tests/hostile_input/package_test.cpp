// Damaged packages through the reader: it throws Error or gives a tree that keeps every promise; it
// never crashes, hangs or takes what it should refuse. Run it under the sanitizers too.

#include <gtest/gtest.h>
#include <zstd.h>

#include <span>

#include "core/package/model_check.h"
#include "core/package/reader.h"
#include "core/package/writer.h"
#include "tests/hostile_input/mutate.h"
#include "tests/package/package_parts.h"
#include "tests/package/sample_tree.h"

namespace bosk {
namespace {

std::string package_of(const SampleTreeOptions& options) {
  Progress progress;
  const auto bytes = package_bytes(sample_tree(options), progress);
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::string sample_package() { return package_of({.levels = {2, 4}, .texels = 8, .views = 3}); }

// Colours that go by their parents', which pays off only where they are alike.
PackageParts parts_with_parents() {
  TreeModel tree = sample_tree({.levels = {3, 4}, .views = 1, .alpha_codewords = 5});
  for (TreeLevel& level : tree.levels) {
    for (std::size_t i = 0; i < level.cells.size(); ++i) {
      if (level.alpha_indices[i] == kPruned) continue;
      level.colour_indices[i] = std::uint16_t((level.cells[i] >> (3 * level.level - 6)) % 40);
    }
  }
  Progress progress;
  const auto bytes = package_bytes(tree, progress);
  return take_apart({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

// Whether the reader takes it; anything but a tree or an Error fails the test.
bool is_taken(const std::string& package) {
  try {
    check_tree_model(read_tree(std::as_bytes(std::span(package)), "hostile.bosk", 1));
    return true;
  } catch (const Error&) {
    return false;
  }
}

TEST(HostilePackage, EveryOneOfEightThousandInjuriesIsFound) {
  Random random(1);
  const std::string package = sample_package();
  for (int i = 0; i < 8000; ++i) {
    const std::string injured = mutated_bytes(random, package);
    EXPECT_EQ(is_taken(injured), injured == package) << i;
  }
}

// The same within a section, with every checksum right: what is behind the checksums must hold as
// well.
TEST(HostilePackage, FiveThousandInjuriesBehindRightChecksumsDoNoHarm) {
  Random random(2);
  const PackageParts whole[] = {take_apart(sample_package()), parts_with_parents()};
  ASSERT_EQ(raw_bytes(whole[1].parts.back())[0], 1) << "the last section goes by parents";
  int taken = 0;
  for (int i = 0; i < 5000; ++i) {
    PackageParts apart = whole[i % 2];
    PackagePart& part = apart.parts[random.below(apart.parts.size())];
    set_raw_bytes(part, mutated_bytes(random, raw_bytes(part)));
    taken += is_taken(put_together(apart));
  }
  EXPECT_GT(taken, 50);  // another licence, another colour: nobody can know
  EXPECT_LT(taken, 4000);
}

// In the compressed bytes themselves, where zstd has to find them or give other bytes.
TEST(HostilePackage, ThreeThousandInjuriesOfCompressedBytesDoNoHarm) {
  Random random(3);
  const PackageParts whole = take_apart(sample_package());
  int tried = 0;
  while (tried < 3000) {
    PackageParts apart = whole;
    PackagePart& part = apart.parts[random.below(apart.parts.size())];
    if (part.codec != kZstd) continue;
    part.bytes = mutated_bytes(random, part.bytes);
    is_taken(put_together(apart));
    ++tried;
  }
}

// In header and section table, sealed again.
TEST(HostilePackage, FourThousandInjuriesOfTheTableDoNoHarm) {
  Random random(4);
  const std::string package = sample_package();
  const std::size_t table_end = kHeaderBytes + take_apart(package).parts.size() * kEntryBytes;
  for (int i = 0; i < 4000; ++i) {
    const std::size_t from = random.below(4) == 0 ? 8 : kHeaderBytes;
    std::string table = mutated_bytes(random, package.substr(from, table_end - from));
    table.resize(table_end - from);
    std::string injured = package.substr(0, from) + table + package.substr(table_end);
    reseal(injured);
    is_taken(injured);
  }
}

}  // namespace
}  // namespace bosk
