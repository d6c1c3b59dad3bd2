// What an impact leaves of an agglomerate. Grains that touch or share a bridge are bonded:
//   damage_ratio      bonds of the first frame that the last one has no more, over all of the first
//   largest_fragment  grains of the greatest cluster of bonded grains, over all grains
//   fragments         clusters of two grains and more, at the end
// Source: the ratio of broken contacts, Thornton, Yin and Adams, J. Phys. D 29 (1996) 424. The
// curve is the distribution of the fragments: grains in fragments of up to a size, over all grains.
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

#include "coupling/base/error.h"
#include "tools/measure/dump_file.h"
#include "tools/measure/kinds.h"

namespace gasgrain {

namespace {

using Bond = std::pair<long, long>;

std::set<Bond> bonds_of(const DumpFrame& frame) {
  const std::size_t a = frame.column("c_pairs[1]");
  const std::size_t b = frame.column("c_pairs[2]");
  std::set<Bond> bonds;
  for (std::size_t n = 0; n < frame.size(); ++n) {
    const auto i = std::lround(frame.value(n, a));
    const auto j = std::lround(frame.value(n, b));
    bonds.insert({std::min(i, j), std::max(i, j)});
  }
  return bonds;
}

// Sizes of the clusters that bonds make of grains, greatest first; a lone grain is one of 1.
std::vector<long> cluster_sizes(const DumpFrame& grains, const std::set<Bond>& bonds,
                                const std::string& file) {
  std::map<long, std::size_t> place;
  const std::size_t id = grains.column("id");
  for (std::size_t n = 0; n < grains.size(); ++n) place[std::lround(grains.value(n, id))] = n;
  std::vector<std::size_t> root(grains.size());
  std::iota(root.begin(), root.end(), std::size_t{0});
  const auto find = [&](std::size_t n) {
    while (root[n] != n) n = root[n] = root[root[n]];
    return n;
  };
  for (const Bond& bond : bonds) {
    const auto a = place.find(bond.first);
    const auto b = place.find(bond.second);
    if (a == place.end() || b == place.end())
      fail("{}: grains {} and {} are bonded, but not both among the grains of the last frame.",
           file, bond.first, bond.second);
    root[find(a->second)] = find(b->second);
  }
  std::map<std::size_t, long> counts;
  for (std::size_t n = 0; n < root.size(); ++n) ++counts[find(n)];
  std::vector<long> sizes;
  for (const auto& [first, count] : counts) sizes.push_back(count);
  std::sort(sizes.rbegin(), sizes.rend());
  return sizes;
}

Measurement measure_fragments(const std::filesystem::path& results, const std::string& bond_dump,
                              const std::string& grain_dump) {
  const auto bonds_file = results / bond_dump;
  const auto frames = read_dump(bonds_file);
  const auto grains = read_dump(results / grain_dump);
  if (frames.size() < 2)
    fail("{}: has one frame; that before the impact and that after it are needed.",
         bonds_file.string());
  const auto before = bonds_of(frames.front());
  const auto after = bonds_of(frames.back());
  if (before.empty())
    fail("{}: the first frame has no bond: there is no agglomerate to break.", bonds_file.string());
  const auto broken = std::count_if(before.begin(), before.end(),
                                    [&](const Bond& bond) { return after.count(bond) == 0; });
  const auto sizes = cluster_sizes(grains.back(), after, bonds_file.string());
  const auto all = static_cast<double>(grains.back().size());
  const auto at_first = cluster_sizes(grains.front(), before, bonds_file.string());
  Measurement measured;
  measured.quantities = {
      {"damage_ratio", static_cast<double>(broken) / static_cast<double>(before.size()), "1", 0.0},
      {"largest_fragment", static_cast<double>(sizes.front()) / all, "1", 0.0},
      {"fragments",
       static_cast<double>(
           std::count_if(sizes.begin(), sizes.end(), [](long size) { return size > 1; })),
       "1", 0.0}};
  measured.curve.columns = {"fragment_size", "share_of_grains_up_to_it"};
  double sum = 0.0;
  for (auto size = sizes.rbegin(); size != sizes.rend(); ++size) {
    sum += static_cast<double>(*size);
    measured.curve.rows.push_back({static_cast<double>(*size), sum / all});
  }
  if (at_first.front() != static_cast<long>(grains.front().size()))
    measured.notes.push_back(fmt::format(
        "{} of {} grains are no part of the agglomerate before the impact.",
        static_cast<long>(grains.front().size()) - at_first.front(), grains.front().size()));
  return measured;
}

}  // namespace

Measure read_fragments(InputTable& table) {
  const std::string bonds = table.text("bonds", "particles/bonds.dump");
  const std::string grains = table.text("grains", "particles/grains.dump");
  return [=](const std::filesystem::path& results) {
    return measure_fragments(results, bonds, grains);
  };
}

}  // namespace gasgrain
