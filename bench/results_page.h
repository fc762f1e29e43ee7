#pragma once

#include <string>
#include <vector>

/// The page of results as text: sections of one table each.
namespace hada {

/// A section: its title and the heads of its table, as "| one | two |".
std::string table(const std::string& title, const std::string& heads);

std::string row(const std::vector<std::string>& cells);

std::string verdict(bool met);

/// What a figure must be at most, and what it should be.
struct Asked {
  double must;
  double goal;
};

/// form  of the value, for fmt
std::string judged(double value, const Asked& asked, const char* form);

/// The page with every section of `fresh` in the place of the one with its title, or at the end.
std::string with_sections(std::string page, const std::string& fresh);

}  // namespace hada
