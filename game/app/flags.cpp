// SPDX-License-Identifier: MIT
#include "game/app/flags.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

namespace sl {

int Program::run(int argc, char** argv) const {
    CLI::App app(about);
    app.name(name);
    app.set_version_flag("--version", fmt::format("{} {}", name, version));
    app.require_subcommand(0, 1);
    app.fallthrough();
    Command chosen;
    declare(Flags(app, chosen));
    try {
        if (argc == 1) {
            const char* arguments[] = {argv[0], unnamed()};
            app.parse(2, arguments);
        } else {
            app.parse(argc, argv);
        }
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : 2;
    }
    prepare();
    if (chosen) return chosen();
    fmt::print(stderr, "{}", app.help());
    return 2;
}

Flag& Flag::within(double low, double high) {
    option_->check(CLI::Range(low, high));
    return *this;
}
Flag& Flag::not_negative() {
    option_->check(CLI::Validator(
        [](const std::string& text) {
            double number = 0.0;
            return CLI::detail::lexical_cast(text, number) && number >= 0.0 ? std::string() : text + " is not a number of at least 0";
        },
        "AT LEAST 0"));
    return *this;
}
Flag& Flag::one_of(const std::vector<std::string>& choices) {
    option_->check(CLI::IsMember(choices));
    return *this;
}
Flag& Flag::required() {
    option_->required();
    return *this;
}
Flag& Flag::needs(const Flag& other) {
    option_->needs(other.option_);
    return *this;
}
Flag& Flag::group(const char* heading) {
    option_->group(heading);
    return *this;
}

Flags Flags::command(const char* name, const char* help) const { return {*app_->add_subcommand(name, help), *chosen_}; }
void Flags::needs_command() const { app_->require_subcommand(1); }
void Flags::footer(const char* text) const { app_->footer(text); }

void Flags::runs(Command command) const {
    app_->callback([chosen = chosen_, command = std::move(command)] { *chosen = command; });
}

namespace {

template <class T>
Flag with_default(CLI::App& app, const char* name, T& value, const char* help) {
    return Flag(app.add_option(name, value, help)->capture_default_str());
}

}  // namespace

Flag Flags::add(const char* name, std::string& value, const char* help) const {
    return value.empty() ? Flag(app_->add_option(name, value, help)) : with_default(*app_, name, value, help);
}
Flag Flags::add(const char* name, std::filesystem::path& value, const char* help) const {
    return Flag(app_->add_option_function<std::string>(name, [&value](const std::string& text) { value = text; }, help));
}
Flag Flags::add(const char* name, std::uint32_t& value, const char* help) const { return with_default(*app_, name, value, help); }
Flag Flags::add(const char* name, std::uint64_t& value, const char* help) const { return with_default(*app_, name, value, help); }
Flag Flags::add(const char* name, float& value, const char* help) const { return with_default(*app_, name, value, help); }
Flag Flags::add(const char* name, double& value, const char* help) const { return with_default(*app_, name, value, help); }
Flag Flags::add(const char* name, std::vector<std::string>& value, const char* help) const {
    return value.empty() ? Flag(app_->add_option(name, value, help)) : with_default(*app_, name, value, help);
}
Flag Flags::add(const char* name, std::optional<std::string>& value, const char* help) const {
    return Flag(app_->add_option_function<std::string>(name, [&value](const std::string& text) { value = text; }, help));
}
Flag Flags::add(const char* name, std::optional<double>& value, const char* help) const {
    return Flag(app_->add_option_function<double>(name, [&value](double number) { value = number; }, help));
}
Flag Flags::add_or_alone(const char* name, std::string& value, const char* alone, const char* help) const {
    const auto store = [&value, alone = std::string(alone)](const std::string& text) { value = text.empty() ? alone : text; };
    return Flag(app_->add_option_function<std::string>(name, store, help)->expected(0, 1)->default_str(alone));
}
Flag Flags::toggle(const char* name, bool& value, const char* help) const { return Flag(app_->add_flag(name, value, help)); }

}  // namespace sl
