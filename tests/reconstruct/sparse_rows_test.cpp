#include "reconstruct/sparse_rows.h"

#include <gtest/gtest.h>

namespace hada {
namespace {

TEST(SparseRows, TransposedHasEveryEntryAtItsColumn) {
  SparseRows matrix(3);  // 1 . 2 / . . . / . 3 4
  matrix.add(0, 1.0f);
  matrix.add(2, 2.0f);
  matrix.end_row();
  matrix.end_row();
  matrix.add(1, 3.0f);
  matrix.add(2, 4.0f);
  matrix.end_row();
  const SparseRows turned = transposed(matrix);
  ASSERT_EQ(turned.rows(), 3);
  EXPECT_EQ(turned.columns, 3);
  ASSERT_EQ(turned.columns_of(2).size(), 2u);
  EXPECT_EQ(turned.columns_of(2)[1], 2);
  EXPECT_EQ(turned.weights_of(2)[1], 4.0f);
  EXPECT_EQ(turned.weights_of(1)[0], 3.0f);
  const SparseRows again = transposed(turned);
  EXPECT_EQ(again.start, matrix.start);
  EXPECT_EQ(again.column, matrix.column);
  EXPECT_EQ(again.weight, matrix.weight);
}

}  // namespace
}  // namespace hada
