#pragma once

#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
} // namespace CLI

namespace dirt {

// Commands and their options over CLI11, whose headers take longer to compile than most commands:
// only command.cpp and program.cpp include them.

/// An option of a command. What changes it returns it.
class Option {
public:
    explicit Option(CLI::Option* option) : option_(option) {}

    Option required() const;
    /// What the help shows in place of its value.
    Option typeName(const std::string& name) const;
    /// Several values in one word, with commas between.
    Option commaSeparated() const;
    /// Takes no more words than the one after its name.
    Option oneWord() const;
    /// Cannot be given together with any of \p others.
    Option excludes(std::initializer_list<Option> others) const;
    /// Leaves it out of the help.
    Option hide() const;
    /// Calls \p action whenever a value is given.
    Option onValue(std::function<void()> action) const;

private:
    CLI::Option* option_;
};

/// A command of the program, or the program itself. Values that options are read into must outlive
/// the parsing. An InputError that a function throws ends it.
class Command {
public:
    explicit Command(CLI::App* app) : app_(app) {}

    std::string name() const;
    /// With those of the commands that it belongs to: "dirt bench frame".
    std::string path() const;

    Command addCommand(const std::string& name, const std::string& description) const;
    /// One of its commands must be given.
    void requireCommand() const;
    /// What it does, once all options are read.
    void onRun(std::function<void()> action) const;

    Option addText(const std::string& names, std::string& value, const std::string& help) const;
    Option addText(const std::string& names, std::optional<std::string>& value,
                   const std::string& help) const;
    Option addTexts(const std::string& names, std::vector<std::string>& values,
                    const std::string& help) const;
    /// \p read gets the text; that of the last, if it is given several times.
    Option addReader(const std::string& names, const std::string& typeName, const std::string& help,
                     const std::function<void(const std::string&)>& read) const;
    /// In place of the option of the same name, whose help it continues; \p read gets the text of
    /// each, if it is given several times.
    Option replaceByReader(const std::string& name, const std::string& typeName,
                           const std::string& moreHelp,
                           std::function<void(const std::string&)> read) const;
    void addFlag(const std::string& names, bool& value, const std::string& help) const;
    /// A flag that does \p action and ends the program, whatever else is given or lacking.
    void addAction(const std::string& name, const std::string& help,
                   std::function<void()> action) const;

    /// The option of that name, if there is one.
    std::optional<Option> find(const std::string& name) const;

private:
    CLI::App* app_;
};

} // namespace dirt
