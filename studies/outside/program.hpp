#pragma once

#include "core/support/child_process.hpp"
#include "core/support/repeatable.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ff::studies {

/// Default limit of a program's run, in seconds.
inline constexpr double usual_deadline = 60;

/// Whether a sampler or an estimator is a program: "command:./mine --seed {seed}".
bool names_command(std::string_view name);

/// The name with a hash of the existing files among the words of the command: a changed program is a different method.
/// A name that has a hash keeps it.
/// @param folder  where the program runs  @throws UserError for a command without words; IoError
std::string full_command_name(std::string_view name, const std::filesystem::path& folder);

/// A user's program. Its words are separated by spaces, or quoted, and {names} in them stand for values.
class Program {
  public:
    /// Replacements: {"{n}", "1024"}.
    using Values = std::vector<std::pair<std::string_view, std::string>>;

    using Seed = OutsideSeed;

    /// @param name  "command:…", with or without a hash  @param folder  where it runs  @param deadline  seconds, above
    /// 0
    /// @throws UserError for a command without words, or for files that do not match the hash; IoError
    Program(std::string_view name, std::filesystem::path folder, double deadline);

    [[nodiscard]] const std::string& full_name() const { return full_name_; }
    /// "command:…" without a hash, for messages.
    [[nodiscard]] std::string title() const;
    [[nodiscard]] bool has(std::string_view placeholder) const;
    /// Refuses words in braces that nothing replaces: {sample} for {samples} would reach the program as it stands.
    /// @param known  placeholders of this kind of program; {seed} and {trial} are known to all  @throws UserError
    void expect_placeholders_among(std::vector<std::string_view> known) const;
    /// Whether one process answers many requests, given as lines on its standard input.
    [[nodiscard]] bool takes_requests() const { return has(requests); }
    /// Whether runs differ from trial to trial.
    [[nodiscard]] bool is_randomised() const { return has("{seed}") || has("{trial}") || takes_requests(); }

    /// Runs it and returns what it prints. Thread-safe. @param place names the run in messages @param most_output bytes
    /// @throws IoError where it cannot be started, fails, takes too long or prints too much
    [[nodiscard]] std::string run(const std::string& place, Seed seed, Values values, std::uint64_t most_output) const;

    /// The program's answer to a request; it is started once per thread. @pre takes_requests()
    /// @param size  total bytes of an answer, from its beginning @throws IoError as `run` does
    [[nodiscard]] std::string ask(const std::string& place, const std::string& line,
                                  const ChildConversation::Size& size, std::uint64_t most_output) const;

    /// Checks that its results repeat, and that they depend on its seed: Repeatable::expect.
    template <class Result, class Telling>
    void expect_repeatable(std::string_view what, const Result& result, const Telling& telling) {
        repeatable_.expect(title(), what, result, telling, takes_requests() ? [this] { hang_up(); } : Restart());
    }

  private:
    static constexpr std::string_view requests = "{requests}";
    using Restart = std::function<void()>;

    /// Ends the process that answers requests of this thread, if there is one.
    void hang_up() const;
    void expect_sound(const std::string& place, const ChildOutput& output, std::uint64_t most_output) const;

    std::string text_;
    std::vector<std::string> words_;
    std::filesystem::path folder_;
    double deadline_;
    std::string full_name_;
    Repeatable repeatable_;
};

}  // namespace ff::studies
