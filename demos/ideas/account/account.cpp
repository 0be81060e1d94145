#include "ideas/account/account.h"

#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "program/exit_code.h"

namespace hooke::ideas {
namespace {

/// Thrown where the command line asks for what there is not.
class BadArguments : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

std::filesystem::path picture_file(const std::string& word) {
  const std::filesystem::path file = word;
  if (file.extension() != ".png")
    throw BadArguments("--picture is '" + word + "': name a file that ends in .png");
  const std::filesystem::path folder = std::filesystem::absolute(file).parent_path();
  if (!std::filesystem::is_directory(folder))
    throw BadArguments("--picture: there is no folder " + folder.string() + ": make it, or name another");
  return std::filesystem::absolute(file);
}

double positive_seconds(const std::string& word) {
  std::size_t read = 0;
  double seconds = 0.0;
  try {
    seconds = std::stod(word, &read);
  } catch (const std::exception&) {
  }
  if (read != word.size() || !std::isfinite(seconds) || seconds <= 0.0)
    throw BadArguments("--seconds is '" + word + "': give a number of seconds > 0");
  return seconds;
}

Account asked_for(int argc, char** argv, Length length) {
  std::optional<std::filesystem::path> picture;
  std::optional<double> longest;
  for (int i = 1; i < argc; i += 2) {
    const std::string word = argv[i];
    if (word != "--picture" && word != "--seconds")
      throw BadArguments("there is no argument '" + word + "': use --picture FILE.png or --seconds S");
    if (word == "--seconds" && length == Length::fixed)
      throw BadArguments("--seconds: this demo is of a fixed length: leave it out");
    if (i + 1 == argc) throw BadArguments(word + " has no value behind it");
    if (word == "--picture" ? picture.has_value() : longest.has_value())
      throw BadArguments(word + " is given twice: give it once");
    if (word == "--picture") picture = picture_file(argv[i + 1]);
    if (word == "--seconds") longest = positive_seconds(argv[i + 1]);
  }
  return {picture.value_or(std::filesystem::path()),
          longest.value_or(std::numeric_limits<double>::infinity())};
}

void print_help(const char* program, const char* title, Length length) {
  const bool can_end = length == Length::as_asked;
  std::printf("%s\n\n%s [--picture FILE.png]%s\n  --picture FILE.png  draws the moment worth seeing\n%s",
              title, std::filesystem::path(program).filename().c_str(), can_end ? " [--seconds S]" : "",
              can_end ? "  --seconds S         simulates at most S seconds\n" : "");
}

}  // namespace

void Account::claim(bool is_true, const char* format, ...) {
  std::printf("%s", is_true ? "  true: " : "  NOT TRUE: ");
  std::va_list values;
  va_start(values, format);
  std::vprintf(format, values);
  va_end(values);
  std::printf("\n");
  all_true_ = all_true_ && is_true;
}

double Account::milliseconds_a_step() const {
  return 1e3 * seconds_ / double(steps_);
}

void Account::print_cost(std::size_t particles, std::size_t springs, unsigned threads) const {
  const auto ending = [](std::size_t count) { return count == 1 ? "" : "s"; };
  std::printf("  cost: %.3g ms a step (%zu particle%s, %zu spring%s, %u thread%s, %llu steps)\n",
              milliseconds_a_step(), particles, ending(particles), springs, ending(springs), threads,
              ending(threads), static_cast<unsigned long long>(steps_));
}

int give_account(int argc, char** argv, const char* title, void (*demo)(Account&), Length length) {
  if (argc == 2 && std::string_view(argv[1]) == "--help") {
    print_help(argv[0], title, length);
    return program::exit_ok;
  }
  try {
    Account account = asked_for(argc, argv, length);
    std::printf("%s\n", title);
    demo(account);
    return account.all_true() ? program::exit_ok : program::exit_unstable;
  } catch (const BadArguments& fault) {
    std::fprintf(stderr, "error: %s\n", fault.what());
    return program::exit_bad_input;
  } catch (const std::exception& fault) {
    std::fprintf(stderr, "error: %s\n", fault.what());
    return program::exit_unstable;
  }
}

}  // namespace hooke::ideas
