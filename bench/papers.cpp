#include <cstdio>
#include <cstdlib>

#include "bench/paper_study.h"

// hada_bench_papers [sheets of each] [picture.png]
int main(int argc, char** argv) {
  const int sheets = argc > 1 ? std::atoi(argv[1]) : 10;
  for (const auto& score : hada::study_papers(sheets)) {
    std::printf("%-16s named right %5.1f %%, mean probability %5.1f %%\n", score.name.c_str(),
                100.0 * score.named_right, 100.0 * score.mean_probability);
  }
  if (argc > 2) hada::write_papers_picture(argv[2]);
}
