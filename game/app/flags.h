// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace sl {

/// What a subcommand runs once the command line is understood; returns the program's exit code.
using Command = std::function<int()>;

/// One flag of a command; each call narrows what it takes.
class Flag {
  public:
    explicit Flag(CLI::Option* option) : option_(option) {}
    Flag& within(double low, double high);
    Flag& not_negative();
    Flag& one_of(const std::vector<std::string>& choices);
    Flag& required();
    Flag& needs(const Flag& other);
    /// Under this heading in the help.
    Flag& group(const char* heading);

  private:
    CLI::Option* option_;
};

class Flags;

/// Understands a command line. `declare` adds flags and commands; `unnamed` is run where the line holds nothing. Returns
/// the program's exit code: what the chosen command returns, 0 for --help and --version, 2 for wrong flags. `prepare` is
/// called before a command runs.
struct Program {
    std::string name, about, version;
    std::function<void(const Flags&)> declare;
    std::function<const char*()> unnamed;
    std::function<void()> prepare;

    int run(int argc, char** argv) const;
};

/// The flags of one command, over CLI11; no other file sees its templates, which cost seconds in each. Values must
/// outlive the parse; what they hold is shown as the default.
class Flags {
  public:
    /// `chosen` becomes what the given subcommand runs.
    Flags(CLI::App& app, Command& chosen) : app_(&app), chosen_(&chosen) {}

    Flags command(const char* name, const char* help) const;
    /// This command is nothing without one of its subcommands.
    void needs_command() const;
    void footer(const char* text) const;
    void runs(Command command) const;

    Flag add(const char* name, std::string& value, const char* help) const;
    Flag add(const char* name, std::filesystem::path& value, const char* help) const;
    Flag add(const char* name, std::uint32_t& value, const char* help) const;
    Flag add(const char* name, std::uint64_t& value, const char* help) const;
    Flag add(const char* name, float& value, const char* help) const;
    Flag add(const char* name, double& value, const char* help) const;
    /// Repeatable.
    Flag add(const char* name, std::vector<std::string>& value, const char* help) const;
    /// Without a value when not given; an empty text is a value.
    Flag add(const char* name, std::optional<std::string>& value, const char* help) const;
    Flag add(const char* name, std::optional<double>& value, const char* help) const;
    /// May stand without a value, and then means `alone`.
    Flag add_or_alone(const char* name, std::string& value, const char* alone, const char* help) const;
    Flag toggle(const char* name, bool& value, const char* help) const;

  private:
    CLI::App* app_;
    Command* chosen_;
};

}  // namespace sl
