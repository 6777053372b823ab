#include "app/cli/command.h"

#include <utility>

#include <CLI/App.hpp>

namespace dirt {

Option Option::required() const {
    option_->required();
    return *this;
}

Option Option::typeName(const std::string& name) const {
    option_->type_name(name);
    return *this;
}

Option Option::commaSeparated() const {
    option_->delimiter(',');
    return *this;
}

Option Option::oneWord() const {
    option_->allow_extra_args(false);
    return *this;
}

Option Option::excludes(std::initializer_list<Option> others) const {
    for (const Option& other : others) option_->excludes(other.option_);
    return *this;
}

Option Option::hide() const {
    option_->group("");
    return *this;
}

Option Option::onValue(std::function<void()> action) const {
    option_->each([action = std::move(action)](const std::string&) { action(); });
    return *this;
}

std::string Command::name() const {
    return app_->get_name();
}

std::string Command::path() const {
    std::string path = app_->get_name();
    for (const CLI::App* parent = app_->get_parent(); parent; parent = parent->get_parent())
        path.insert(0, parent->get_name() + " ");
    return path;
}

Command Command::addCommand(const std::string& name, const std::string& description) const {
    return Command(app_->add_subcommand(name, description));
}

void Command::requireCommand() const {
    app_->require_subcommand(1);
}

void Command::onRun(std::function<void()> action) const {
    app_->callback(std::move(action));
}

Option Command::addText(const std::string& names, std::string& value,
                        const std::string& help) const {
    return Option(app_->add_option(names, value, help));
}

Option Command::addText(const std::string& names, std::optional<std::string>& value,
                        const std::string& help) const {
    return Option(app_->add_option(names, value, help));
}

Option Command::addTexts(const std::string& names, std::vector<std::string>& values,
                         const std::string& help) const {
    return Option(app_->add_option(names, values, help));
}

Option Command::addReader(const std::string& names, const std::string& typeName,
                          const std::string& help,
                          const std::function<void(const std::string&)>& read) const {
    return Option(app_->add_option_function<std::string>(names, read, help)
                      ->type_name(typeName)
                      ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast));
}

Option Command::replaceByReader(const std::string& name, const std::string& typeName,
                                const std::string& moreHelp,
                                std::function<void(const std::string&)> read) const {
    CLI::Option* const replaced = app_->get_option(name);
    const std::string help = replaced->get_description() + moreHelp;
    app_->remove_option(replaced);
    const auto readAll = [read = std::move(read)](const std::vector<std::string>& texts) {
        for (const std::string& text : texts) read(text);
    };
    return Option(app_->add_option_function<std::vector<std::string>>(name, readAll, help)
                      ->type_name(typeName)
                      ->allow_extra_args(false)
                      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll));
}

void Command::addFlag(const std::string& names, bool& value, const std::string& help) const {
    app_->add_flag(names, value, help);
}

void Command::addAction(const std::string& name, const std::string& help,
                        std::function<void()> action) const {
    const auto run = [action = std::move(action)] {
        action();
        throw CLI::Success();
    };
    app_->add_flag_callback(name, run, help)->trigger_on_parse();
}

std::optional<Option> Command::find(const std::string& name) const {
    CLI::Option* const option = app_->get_option_no_throw(name);
    return option ? std::optional(Option(option)) : std::nullopt;
}

} // namespace dirt
