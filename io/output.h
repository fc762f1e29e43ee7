#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace hada {

/// Files that appear in a folder all at once, or not at all.
///
/// Everything is written into a hidden scratch folder beside the target and renamed into place by
/// `commit`. Destruction without `commit` (an Error) and an interrupt (Ctrl-C, SIGTERM) remove the
/// scratch folder, and the folders that were made for it, and leave what was there before
/// untouched.
class Output {
 public:
  /// Makes `folder` (and its parents) if it is missing.
  /// throws  Error if that is impossible, or nothing may be written there
  explicit Output(const std::filesystem::path& folder);
  ~Output();
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;

  /// Where to write the file that will be `folder/name`; `name` may have sub-folders.
  std::filesystem::path file(const std::string& name);
  const std::filesystem::path& folder() const { return folder_; }

  /// Renames every file into place, in the order of `file`. Nothing can be added afterwards.
  /// throws  Error, before anything is renamed, if a file was not written or a folder has its name
  void commit();

 private:
  std::filesystem::path folder_;
  std::filesystem::path scratch_;  // empty after `commit`
  std::vector<std::string> names_;
};

/// Writes `text` to `path` through an `Output`; a device or a pipe is written to directly.
void write_text(const std::filesystem::path& path, const std::string& text);

/// From here on an interrupt (SIGINT, SIGTERM) removes the scratch of every living Output and ends
/// the program with code 130. Called once, in `main`, before any thread is started.
void clean_up_on_interrupt();

/// What else an interrupt does, before anything is removed, for programs that serve: `work` runs in
/// a thread of its own while the others go on. An empty function takes it back.
void do_first_on_interrupt(std::function<void()> work);

}  // namespace hada
