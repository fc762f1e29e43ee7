// hada_bench_streaming [side] [lights] [most_anonymous_MB]: memory and time of `hada reconstruct`
// on coloured 16-bit pictures of side x side pixels. Goal: 4000 pixels and 12 lights within half
// the size of the pictures as floats, and with the same surface when the system refuses the program
// more than most_anonymous_MB that no file backs.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <numbers>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "bench/process.h"
#include "core/parallel.h"
#include "core/random.h"
#include "io/image_file.h"

namespace hada {
namespace {

namespace fs = std::filesystem;

std::vector<Eigen::Vector3d> ring(int count) {
  std::vector<Eigen::Vector3d> lights;
  for (int k = 0; k < count; ++k) {
    const double azimuth = 2.0 * std::numbers::pi * (k + 0.3) / count;
    const double slant = k % 2 == 0 ? 0.8 : 0.55;
    lights.emplace_back(std::sin(slant) * std::cos(azimuth), std::sin(slant) * std::sin(azimuth),
                        std::cos(slant));
  }
  return lights;
}

// A waved, printed sheet and a matte ball beside it on a black table; x to the right, y down, both
// from 0 to 1. Albedo times normal.
Eigen::Vector3d scaled_normal(double x, double y, int channel) {
  const Eigen::Vector2d from_ball(x - 0.9, y - 0.5);
  constexpr double ball = 0.07;
  if (from_ball.norm() < ball) {
    const double z = std::sqrt(1.0 - from_ball.squaredNorm() / (ball * ball));
    return 0.7 * Eigen::Vector3d(from_ball.x() / ball, -from_ball.y() / ball, z);
  }
  const bool on_sheet = x > 0.02 && x < 0.8 && y > 0.02 && y < 0.98;
  if (!on_sheet) return {0.0, 0.0, 0.01};
  const double slope_x = 0.25 * std::sin(90.0 * x + 20.0 * y) + 0.1 * std::cos(301.0 * x);
  const double slope_y = 0.2 * std::cos(70.0 * y - 30.0 * x) + 0.1 * std::sin(257.0 * y);
  const bool printed = std::sin(150.0 * x) * std::sin(40.0 * y) > 0.6;
  const double albedo = printed ? 0.25 + 0.1 * channel : 0.75 - 0.05 * channel;
  return albedo * Eigen::Vector3d(-slope_x, -slope_y, 1.0).normalized();
}

Image picture(int side, const Eigen::Vector3d& light, Seed seed) {
  Image image(side, side, 3);
  constexpr double noise = 0.004;
  for_each_index(side, [&](int row) {
    for (int col = 0; col < side; ++col) {
      for (int channel = 0; channel < 3; ++channel) {
        const Eigen::Vector3d n = scaled_normal((col + 0.5) / side, (row + 0.5) / side, channel);
        const double luck = uniform(seed, row, col, channel) - 0.5;
        image.planes[std::size_t(channel)](row, col) =
            float(std::max(0.0, n.dot(light)) + noise * luck);
      }
    }
  });
  return image;
}

int run(int side, int lights, int most_anonymous_mb) {
  std::string pattern = (fs::temp_directory_path() / "hada-streaming-XXXXXX").string();
  const fs::path folder = mkdtemp(pattern.data());
  fs::create_directory(folder / "capture");
  const auto directions = ring(lights);
  for (int k = 0; k < lights; ++k) {
    const std::string name = "light_" + std::to_string(100 + k) + ".png";
    write_integer_image(folder / "capture" / name,
                        picture(side, directions[std::size_t(k)], Seed(k)), 16);
  }
  const double floats = 3.0 * 4.0 * side * side * lights / 0x1p20;
  std::printf("%d pictures of %d x %d, 3 channels: %.0f MB as floats\n", lights, side, side,
              floats);
  const auto reconstruct = [&](const char* out, int most_mb) {
    const ProcessCost cost = run_process(
        HADA_PROGRAM, {"reconstruct", (folder / "capture").string(), "-o", (folder / out).string()},
        most_mb);
    std::printf("%-9s exit code %d, %.0f s, at most %.0f MB resident, %.0f MB of it anonymous\n",
                out, cost.exit_code, cost.seconds, cost.megabytes, cost.anonymous_megabytes);
    return cost.exit_code;
  };
  int failures = reconstruct("free", 0);
  if (most_anonymous_mb > 0) {
    failures += reconstruct("limited", most_anonymous_mb);
    const bool same = failures == 0 && same_bytes(folder / "free", folder / "limited");
    std::printf("limited to %d MB: %s bytes\n", most_anonymous_mb, same ? "the same" : "OTHER");
    failures += !same;
  }
  fs::remove_all(folder);
  return failures == 0 ? 0 : 1;
}

}  // namespace
}  // namespace hada

int main(int argc, char** argv) {
  const auto number = [&](int i, int otherwise) {
    return argc > i ? std::atoi(argv[i]) : otherwise;
  };
  return hada::run(number(1, 4000), number(2, 12), number(3, 0));
}
