#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sheet/aim.h"
#include "sheet/fold_log.h"
#include "sheet/held_swing.h"
#include "sheet/stack.h"

namespace hada {

/// What is held while a face is turned.
struct Grip {
  FoldStep step;                        // that a drop adds to the log; its angle follows the drag
  Eigen::Vector3d on_axis;              // a place on the axis
  Eigen::Vector3d along;                // the axis, unit length; turns are counted about it
  std::array<Eigen::Vector3d, 2> axis;  // its ends
  Eigen::Vector3d click;                // where the face was taken
  Eigen::Vector3d centre;               // of the face
  int face = -1;
  std::optional<HeldSwing> swing = {};  // once it is dragged about a crease
};

/// A sheet that is being folded: a log, its states, and how many of its steps are in force.
class FoldSession {
 public:
  /// throws  Error naming the step that cannot be done, or if there are too many
  explicit FoldSession(FoldLog log = {});

  const FoldLog& log() const { return log_; }
  /// The part of the log that is in force.
  FoldLog done() const;
  int at() const { return at_; }
  const FoldState& state() const { return states_[std::size_t(at_)]; }
  const FoldState& state_after(int step) const { return states_.at(std::size_t(step)); }
  std::vector<FoldState> states() const { return {states_.begin(), states_.begin() + at_ + 1}; }
  const Stack& stack() const { return stack_; }
  /// Whether lines can be drawn on the flat sheet: nothing is folded yet.
  bool is_open() const;

  /// Adds a step behind those in force; what was undone is forgotten.
  /// throws  Error if it cannot be done; then nothing has changed
  void add(const FoldStep& step);
  /// Puts so many steps in force.
  void go_to(int at);

  std::vector<Eigen::Vector2d> pins;    // places on the flat sheet that are held
  std::vector<Eigen::Vector2d> chosen;  // places of the faces that are chosen
  std::optional<Grip> grip;
  std::optional<FoldState> dragged;  // while something is held

 private:
  void look();

  FoldLog log_;
  std::vector<FoldState> states_;
  Stack stack_;  // of the state in force
  int at_ = 0;
};

/// Takes the face under the pointer: its axis is what the click means, or the line given.
///
/// line    of an axis drawn by hand on the flat sheet, seen from above; what is held turns
/// throws  Error if there is no face, or no crease that it could turn about
Grip taken(const FoldSession& session, const Ray& ray,
           const std::optional<std::array<Eigen::Vector2d, 2>>& line);

/// The faces that are chosen.
std::vector<int> chosen_now(const FoldSession& session);

/// Takes a place of the flat sheet into `places`, or those of its face out: the place itself, or
/// what is under the pointer.
/// throws  Error if there is no paper
void toggle(const FoldSession& session, std::vector<Eigen::Vector2d>& places,
            const Eigen::Vector2d& place);
void toggle(const FoldSession& session, std::vector<Eigen::Vector2d>& places, const Ray& ray);

/// On the way to step `at` (from 1): a share of it is done, if it is one that turns paper.
FoldState between(const FoldSession& session, int at, double share);

/// Turns what is held to where the pointer is, in whole multiples of `whole_deg` (> 0), or freely.
void drag(FoldSession& session, const Ray& ray, double whole_deg);

/// The step of a line that was drawn on the open sheet from above: "fold" or "crease".
/// throws  Error if the sheet is not open
FoldStep step_of_line(const FoldSession& session, FoldAction action, const Eigen::Vector3d& from,
                      const Eigen::Vector3d& to, Crease crease);

}  // namespace hada
