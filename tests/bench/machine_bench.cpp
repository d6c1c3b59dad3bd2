// What one core of this machine can move and compute: the denominators of docs/dem-speed.md, 'The
// limit on paper'. Working sets of 0.5, 8 and 512 MiB are meant to lie in L2, in L3 and in memory.
//
// copy, triad   bytes read and written a second by a = b and a = b + s c (the reading of a line
//               before it is written is not counted)
// rows          bytes a second of rows of three doubles read at indices that scatter over 64
//               neighbouring rows, as the neighbours of sorted grains do
// fma, div, sqrt  results a second of independent chains: single doubles and vectors of 2 (fma as a
//               product and a sum), and where the processor has them of 4 (AVX2) and 8 (AVX-512)
#include <benchmark/benchmark.h>
#include <immintrin.h>

#include <array>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace {

constexpr std::size_t kib = 1024;
constexpr std::array<std::size_t, 3> working_sets{512 * kib, 8 * kib* kib, 512 * kib* kib};
constexpr int chains = 12;   // more than latency times throughput of any of the three operations
constexpr int rounds = 256;  // of each chain, a measured iteration

void set_bytes(benchmark::State& state, std::size_t bytes) {
  state.SetBytesProcessed(static_cast<std::int64_t>(bytes) * state.iterations());
}

void copy(benchmark::State& state, std::size_t bytes) {
  const std::size_t n = bytes / (2 * sizeof(double));
  std::vector<double> a(n, 0.0);
  const std::vector<double> b(n, 1.0);
  for (auto _ : state) {
    for (std::size_t i = 0; i < n; ++i) a[i] = b[i];
    benchmark::ClobberMemory();
  }
  set_bytes(state, 2 * n * sizeof(double));
}

void triad(benchmark::State& state, std::size_t bytes) {
  const std::size_t n = bytes / (3 * sizeof(double));
  std::vector<double> a(n, 0.0);
  const std::vector<double> b(n, 1.0);
  const std::vector<double> c(n, 2.0);
  for (auto _ : state) {
    for (std::size_t i = 0; i < n; ++i) a[i] = b[i] + 3.0 * c[i];
    benchmark::ClobberMemory();
  }
  set_bytes(state, 3 * n * sizeof(double));
}

void rows(benchmark::State& state, std::size_t bytes) {
  constexpr std::size_t row = 3 * sizeof(double);
  constexpr std::size_t spread = 64;
  constexpr std::size_t sums = 4;
  const std::size_t n = bytes / (row + sizeof(int));
  const std::vector<std::array<double, 3>> values(n + spread, {1.0, 2.0, 3.0});
  std::vector<int> index(n);
  std::mt19937 random(5);
  std::uniform_int_distribution<int> shift(0, spread - 1);
  for (std::size_t i = 0; i < n; ++i) index[i] = static_cast<int>(i) + shift(random);
  for (auto _ : state) {
    // Sums of their own, or each row would wait for the one before it.
    double sum[sums][3] = {};
    for (std::size_t i = 0; i + sums <= n; i += sums)
#pragma GCC unroll 4
      for (std::size_t m = 0; m < sums; ++m) {
        const double* at = values[static_cast<std::size_t>(index[i + m])].data();
        sum[m][0] += at[0];
        sum[m][1] += at[1];
        sum[m][2] += at[2];
      }
    benchmark::DoNotOptimize(sum);
  }
  set_bytes(state, n * row);
}

// An intrinsic needs a function of its instruction set around it, whence a macro and no template.
// STEP makes x[k] of x[k], and keeps it near 1.
#define GASGRAIN_CHAINS(NAME, ISA, WIDTH, VECTOR, PREFIX, STEP)                \
  [[gnu::target(ISA)]] void NAME(benchmark::State& state) {                    \
    VECTOR x[chains];                                                          \
    for (int k = 0; k < chains; ++k) x[k] = PREFIX##_set1_pd(1.0 + 0.01 * k);  \
    VECTOR a = PREFIX##_set1_pd(0.999), b = PREFIX##_set1_pd(0.001);           \
    benchmark::DoNotOptimize(a);                                               \
    benchmark::DoNotOptimize(b);                                               \
    for (auto _ : state) {                                                     \
      for (int n = 0; n < rounds; ++n)                                         \
        _Pragma("GCC unroll 12") for (int k = 0; k < chains; ++k) x[k] = STEP; \
      for (int k = 0; k < chains; ++k) benchmark::DoNotOptimize(x[k]);         \
    }                                                                          \
    state.SetItemsProcessed(state.iterations() * (WIDTH * rounds * chains));   \
  }

GASGRAIN_CHAINS(fma_1, "sse2", 1, __m128d, _mm, _mm_add_sd(_mm_mul_sd(x[k], a), b))
GASGRAIN_CHAINS(div_1, "sse2", 1, __m128d, _mm, _mm_div_sd(a, x[k]))
GASGRAIN_CHAINS(sqrt_1, "sse2", 1, __m128d, _mm, _mm_sqrt_sd(x[k], x[k]))
GASGRAIN_CHAINS(fma_2, "sse2", 2, __m128d, _mm, _mm_add_pd(_mm_mul_pd(x[k], a), b))
GASGRAIN_CHAINS(div_2, "sse2", 2, __m128d, _mm, _mm_div_pd(a, x[k]))
GASGRAIN_CHAINS(sqrt_2, "sse2", 2, __m128d, _mm, _mm_sqrt_pd(x[k]))
GASGRAIN_CHAINS(fma_4, "avx2,fma", 4, __m256d, _mm256, _mm256_fmadd_pd(x[k], a, b))
GASGRAIN_CHAINS(div_4, "avx2,fma", 4, __m256d, _mm256, _mm256_div_pd(a, x[k]))
GASGRAIN_CHAINS(sqrt_4, "avx2,fma", 4, __m256d, _mm256, _mm256_sqrt_pd(x[k]))
GASGRAIN_CHAINS(fma_8, "avx512f", 8, __m512d, _mm512, _mm512_fmadd_pd(x[k], a, b))
GASGRAIN_CHAINS(div_8, "avx512f", 8, __m512d, _mm512, _mm512_div_pd(a, x[k]))
// Of all eight by a mask: without one GCC 12 warns of its own header.
GASGRAIN_CHAINS(sqrt_8, "avx512f", 8, __m512d, _mm512, _mm512_maskz_sqrt_pd(0xff, x[k]))

void add_moving(const std::string& name, void (*run)(benchmark::State&, std::size_t)) {
  for (const std::size_t bytes : working_sets)
    benchmark::RegisterBenchmark((name + "/" + std::to_string(bytes / kib) + "KiB").c_str(), run,
                                 bytes);
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  add_moving("copy", copy);
  add_moving("triad", triad);
  add_moving("rows", rows);
  benchmark::RegisterBenchmark("fma/1", fma_1);
  benchmark::RegisterBenchmark("div/1", div_1);
  benchmark::RegisterBenchmark("sqrt/1", sqrt_1);
  benchmark::RegisterBenchmark("fma/2", fma_2);
  benchmark::RegisterBenchmark("div/2", div_2);
  benchmark::RegisterBenchmark("sqrt/2", sqrt_2);
  if (__builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0) {
    benchmark::RegisterBenchmark("fma/4", fma_4);
    benchmark::RegisterBenchmark("div/4", div_4);
    benchmark::RegisterBenchmark("sqrt/4", sqrt_4);
  }
  if (__builtin_cpu_supports("avx512f") != 0) {
    benchmark::RegisterBenchmark("fma/8", fma_8);
    benchmark::RegisterBenchmark("div/8", div_8);
    benchmark::RegisterBenchmark("sqrt/8", sqrt_8);
  }
  benchmark::RunSpecifiedBenchmarks();
}
