#include "io/fold_file.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "io/crease_lines.h"
#include "tests/io/temporary_folder.h"

namespace hada {
namespace {

using testing::HasSubstr;

FoldFile read_back(const std::string& text, const std::string& name = "a.fold") {
  const TemporaryFolder folder;
  put(folder / name, text);
  return read_crease_pattern(folder / name);
}

FoldFrame triangles() {
  FoldFrame frame;
  frame.title = "two triangles";
  frame.classes = {"foldedForm"};
  frame.flat = false;
  frame.vertices = {{0, 0, 0}, {1, 0, 0.1}, {1, 1, 0}, {0, 1, 1.0 / 3.0}};
  frame.edges = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 2}};
  frame.assignment = {Crease::border, Crease::border, Crease::border, Crease::border,
                      Crease::valley};
  frame.fold_angle_deg = {0, 0, 0, std::nan(""), 33.25};
  frame.faces = {{0, 1, 2}, {0, 2, 3}};
  frame.face_orders = {{0, 1, -1}};
  return frame;
}

TEST(FoldFile, ReturnsWhatWasWritten) {
  FoldFile file;
  file.title = "pair";
  file.frames = {triangles(), triangles()};
  file.frames[1].flat = true;
  for (auto& vertex : file.frames[1].vertices) vertex.z() = 0.0;
  const FoldFile again = read_back(fold_text(file));
  EXPECT_EQ(again.title, "pair");
  ASSERT_EQ(again.frames.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    const FoldFrame &a = again.frames[i], &b = file.frames[i];
    EXPECT_EQ(a.vertices, b.vertices);
    EXPECT_EQ(a.flat, b.flat);
    EXPECT_EQ(a.edges, b.edges);
    EXPECT_EQ(a.assignment, b.assignment);
    EXPECT_EQ(a.faces, b.faces);
    EXPECT_EQ(a.face_orders, b.face_orders);
    EXPECT_EQ(a.fold_angle_deg[4], 33.25);
    EXPECT_TRUE(std::isnan(a.fold_angle_deg[3]));
  }
}

TEST(FoldFile, FillsInWhatAFrameInherits) {
  const FoldFile file = read_back(R"({"vertices_coords": [[0,0],[1,0],[0,1]],
    "edges_vertices": [[0,1],[1,2],[2,0]], "faces_vertices": [[0,1,2]],
    "file_frames": [{"frame_inherit": true, "frame_parent": 0,
                     "vertices_coords": [[0,0,1],[1,0,1],[0,1,1]]},
                    {"frame_inherit": true, "frame_parent": 1, "edges_assignment": ["B","b","B"]},
                    {"vertices_coords": [[5,5]]}]})");
  ASSERT_EQ(file.frames.size(), 4u);
  EXPECT_EQ(file.frames[1].edges.size(), 3u);
  EXPECT_EQ(file.frames[2].vertices[0].z(), 1.0);
  EXPECT_EQ(file.frames[2].assignment.size(), 3u);
  EXPECT_TRUE(file.frames[3].edges.empty());
}

TEST(FoldFile, NamesThePlaceOfEveryFlaw) {
  const auto error = [](const std::string& text) { return error_of([&] { read_back(text); }); };
  const std::string start = R"({"vertices_coords": [[0,0],[1,0],[0,1]], )";
  EXPECT_THAT(error("[]"), HasSubstr("is no FOLD file"));
  EXPECT_THAT(error("{"), HasSubstr("not valid JSON"));
  EXPECT_THAT(error(R"({"vertices_coords": 3})"), HasSubstr("vertices_coords must be a list"));
  EXPECT_THAT(error(R"({"vertices_coords": [[0]]})"), HasSubstr("vertices_coords[0] must be two"));
  EXPECT_THAT(error(R"({"vertices_coords": [[0,"x"]]})"), HasSubstr("finite"));
  EXPECT_THAT(error(start + R"("edges_vertices": [[0,3]]})"), HasSubstr("points to 3"));
  EXPECT_THAT(error(start + R"("edges_vertices": [[0,-1]]})"), HasSubstr("points to -1"));
  EXPECT_THAT(error(start + R"("edges_vertices": [[0,0.5]]})"), HasSubstr("whole numbers"));
  EXPECT_THAT(error(start + R"("edges_vertices": [[1,1]]})"), HasSubstr("at one vertex"));
  EXPECT_THAT(error(start + R"("edges_vertices": [[0,1]], "edges_assignment": ["B","M"]})"),
              HasSubstr("has 2 entries where 1"));
  EXPECT_THAT(error(start + R"("edges_vertices": [[0,1]], "edges_assignment": ["Q"]})"),
              HasSubstr("must be one of B, M"));
  EXPECT_THAT(error(start + R"("edges_vertices": [[0,1]], "edges_foldAngle": [999]})"),
              HasSubstr("-360"));
  EXPECT_THAT(error(start + R"("faces_vertices": [[0,1]]})"), HasSubstr("three vertices"));
  EXPECT_THAT(error(start + R"("faces_vertices": [[0,1,2]], "faceOrders": [[0,0,1]]})"),
              HasSubstr("on itself"));
  EXPECT_THAT(error(R"({"file_frames": [{"frame_inherit": true, "frame_parent": 1}]})"),
              HasSubstr("circle"));
  EXPECT_THAT(error(R"({"file_frames": [7]})"), HasSubstr("object"));
  EXPECT_THAT(error_of([] { read_fold("/nowhere/a.fold"); }), HasSubstr("/nowhere/a.fold"));
  EXPECT_THAT(error_of([] { read_crease_pattern("a.txt"); }), HasSubstr("give .fold"));
}

TEST(FoldFile, ReadsLinesOfOripa) {
  const FoldFile cp = read_back("1 0 0 1 0\r\n2 0 0 1.5e0 1\n\n3 -1 0 1 1\n4 0 0 0 1\n", "a.cp");
  ASSERT_EQ(cp.frames[0].edges.size(), 4u);
  EXPECT_EQ(cp.frames[0].assignment,
            (std::vector<Crease>{Crease::border, Crease::mountain, Crease::valley, Crease::flat}));
  EXPECT_EQ(cp.frames[0].vertices[3].x(), 1.5);
  const FoldFile opx = read_back(
      R"(<java><object class="oripa.OriLineProxy"><void property="type"><int>2</int></void>
<void property="x0"><double>200.0</double></void><void property="y1"><double>-3</double></void>
</object></java>)",
      "a.opx");
  ASSERT_EQ(opx.frames[0].edges.size(), 1u);
  EXPECT_EQ(opx.frames[0].vertices[0].x(), 200.0);
  EXPECT_EQ(opx.frames[0].vertices[1].y(), -3.0);
  EXPECT_THAT(error_of([] { read_back("7 0 0 1 1\n", "a.cp"); }),
              HasSubstr("line 1: 7 is no kind"));
  EXPECT_THAT(error_of([] { read_back("2 0 0 1\n", "a.cp"); }), HasSubstr("four numbers"));
  EXPECT_THAT(error_of([] { read_back("<java/>", "a.opx"); }), HasSubstr("ORIPA"));
}

TEST(FoldFile, ReadsColouredLinesOfADrawing) {
  const FoldFile svg = read_back(
      R"svg(<?xml version="1.0"?><svg><style>.m{stroke:#f00; opacity:.5}</style><!-- <line/> -->
<g transform="translate(10,20) scale(2)"><line class="m" x1="0" y1="0" x2="1" y2="0"/></g>
<path stroke="#0000FF" d="M0,0l1-2 3,4 H9 z"/><line style="stroke:rgb(0,0,0)" x2='4'/>
<polyline stroke="yellow" points="0,0 1,1 2,0"/><line stroke="none" x2="3"/></svg>)svg",
      "a.svg");
  const FoldFrame& frame = svg.frames[0];
  ASSERT_EQ(frame.edges.size(), 8u);
  EXPECT_EQ(frame.assignment[0], Crease::mountain);
  EXPECT_EQ(frame.fold_angle_deg[0], -90.0);
  EXPECT_EQ(frame.vertices[0], Eigen::Vector3d(10, -20, 0));
  EXPECT_EQ(frame.vertices[1], Eigen::Vector3d(12, -20, 0));
  EXPECT_EQ(frame.assignment[1], Crease::valley);
  EXPECT_EQ(frame.vertices[3], Eigen::Vector3d(1, 2, 0));
  EXPECT_EQ(frame.vertices[5], Eigen::Vector3d(4, -2, 0));
  EXPECT_EQ(frame.vertices[7], Eigen::Vector3d(9, -2, 0));
  EXPECT_EQ(frame.vertices[9], Eigen::Vector3d(0, 0, 0));
  EXPECT_EQ(frame.assignment[5], Crease::border);
  EXPECT_EQ(frame.assignment[6], Crease::flat);
}

RC_GTEST_PROP(FoldFile, SurvivesCutsAndChangedBytes,
              (std::uint16_t place, char byte, bool cut, std::uint8_t kind)) {
  FoldFile file;
  file.frames = {triangles(), triangles()};
  const std::string names[] = {"a.fold", "a.cp", "a.svg", "a.opx"};
  const std::string texts[] = {
      fold_text(file), "2 0 0 1 1\n3 0 0 1 -1\n",
      "<svg><path stroke='red' d='M0 0L1 1'/><rect width='3' height='2' stroke='#000'/></svg>",
      "<object class=\"oripa.OriLineProxy\"><void property=\"x0\"><double>2</double></void>"};
  std::string text = texts[kind % 4];
  const std::size_t at = place % text.size();
  if (cut)
    text.resize(at);
  else
    text[at] = byte;
  error_of([&] { read_back(text, names[kind % 4]); });
}

}  // namespace
}  // namespace hada
