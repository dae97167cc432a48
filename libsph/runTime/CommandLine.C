#include "runTime/CommandLine.H"

#include "primitives/error.H"
#include "runTime/log.H"

#include <boost/program_options.hpp>
#include <cstdlib>
#include <iostream>

namespace po = boost::program_options;

namespace sph
{

struct CommandLine::Data
{
    word application;
    std::string text;           // as it was typed
    std::string description;
    std::vector<Option> options;
    po::variables_map values;

    po::options_description described() const;
    [[noreturn]] void unknown(const std::string& text) const;
    void parse(int argc, char* argv[]);
    void printUsage(bool full) const;
    std::filesystem::path caseDir() const;
};

po::options_description CommandLine::Data::described() const
{
    po::options_description all;
    all.add_options()("h", "");
    for (const Option& option : options)
    {
        if (option.argument.empty())
        {
            all.add_options()(option.name.c_str(), "");
        }
        else
        {
            all.add_options()
            (
                option.name.c_str(), po::value<std::string>(), ""
            );
        }
    }
    return all;
}

void CommandLine::Data::unknown(const std::string& text) const
{
    wordList valid;
    for (const Option& option : options)
    {
        valid.push_back('-' + option.name);
    }
    const std::size_t begin = std::min(text.find_first_not_of('-'), text.size());
    const word guess = nearest('-' + text.substr(begin), valid);
    throw Error
    (
        (text[0] == '-' ? "Unknown option " : "Unexpected argument ") + text
      + (guess.empty() ? "" : "; did you mean '" + guess + "'?")
      + "\n\nValid options :\n\n" + listOfWords(valid)
    );
}

void CommandLine::Data::parse(int argc, char* argv[])
{
    namespace style = po::command_line_style;
    const po::options_description all = described();
    std::vector<std::string> others;
    const auto name = [](const po::error_with_option_name& error)
    {
        const std::string text = error.get_option_name();
        return '-' + text.substr(std::min(text.find_first_not_of('-'), text.size()));
    };

    try
    {
        const po::parsed_options parsed =
            po::command_line_parser(argc, argv)
           .options(all)
           .style
            (
                style::allow_long | style::long_allow_next
              | style::long_allow_adjacent | style::allow_long_disguise
            )
           .allow_unregistered()
           .run();
        for (const auto& option : parsed.options)
        {
            if (option.unregistered || option.position_key >= 0)
            {
                unknown(option.original_tokens.front());
            }
        }
        po::store(parsed, values);
    }
    catch (const po::multiple_occurrences& error)
    {
        throw Error("The option " + name(error) + " is given twice");
    }
    catch (const po::invalid_command_line_syntax& error)
    {
        throw Error
        (
            error.kind() == po::invalid_syntax::missing_parameter
          ? "The option " + name(error) + " needs an argument"
          : "The option " + name(error) + " takes no argument"
        );
    }
    catch (const po::error& error)
    {
        throw Error(error.what());
    }
}

void CommandLine::Data::printUsage(const bool full) const
{
    std::cout
        << "\nUsage: " << application << " [OPTIONS]\n\n"
        << description << "\n\nOptions:\n";
    for (const Option& option : options)
    {
        std::string left = "  -" + option.name;
        if (!option.argument.empty())
        {
            left += " <" + option.argument + '>';
        }
        left.resize(std::max<std::size_t>(left.size() + 2, 27), ' ');
        std::cout << left << option.help << '\n';
    }
    if (full)
    {
        std::cout
            << "\nOptions may be written with one dash or two; -h is -help.\n"
            << "\nSignals:\n"
            << "  INT, TERM                write the state and stop\n"
            << "  USR1                     write the state and go on\n"
            << "\nEnvironment:\n"
            << "  OMP_NUM_THREADS          number of threads\n"
            << "\nBuild: " << buildVersion() << '\n';
    }
    std::cout << std::endl;
}

std::filesystem::path CommandLine::Data::caseDir() const
{
    const auto given = values.find("case");
    std::filesystem::path dir = std::filesystem::absolute
    (
        given == values.end() ? "." : given->second.as<std::string>()
    ).lexically_normal();
    return dir.has_filename() ? dir : dir.parent_path();
}


CommandLine::CommandLine
(
    int argc, char* argv[],
    const std::string& description, const std::vector<Option>& options
)
:
    data_(std::make_unique<Data>())
{
    Data& d = *data_;
    d.application = std::filesystem::path(argv[0]).filename().string();
    d.text = d.application;
    for (int i = 1; i < argc; ++i)
    {
        d.text += ' ' + std::string(argv[i]);
    }
    d.description = description;
    d.options.push_back
    (
        {"case", "dir", "Case directory instead of the present one"}
    );
    d.options.insert(d.options.end(), options.begin(), options.end());
    d.options.push_back({"help", "", "Print this text and exit"});
    d.options.push_back
    (
        {"help-full", "", "The same with signals and environment"}
    );

    d.parse(argc, argv);
    if (found("help") || found("help-full") || found("h"))
    {
        d.printUsage(found("help-full"));
        std::exit(0);
    }
}

CommandLine::~CommandLine() = default;

bool CommandLine::found(const word& option) const
{
    return data_->values.count(option) > 0;
}

std::string CommandLine::value(const word& option) const
{
    if (!found(option))
    {
        throw Error("The option -" + option + " is needed");
    }
    return data_->values[option].as<std::string>();
}

std::string CommandLine::valueOr
(
    const word& option, const std::string& other
) const
{
    return found(option) ? value(option) : other;
}

const word& CommandLine::application() const
{
    return data_->application;
}

std::filesystem::path CommandLine::casePath() const
{
    return data_->caseDir();
}

std::filesystem::path CommandLine::caseDir() const
{
    const std::filesystem::path dir = data_->caseDir();
    if (!std::filesystem::is_directory(dir))
    {
        throw Error("There is no case directory " + dir.string());
    }
    if (!std::filesystem::is_directory(dir/"system"))
    {
        throw Error
        (
            dir.string() + " is no case: it has no folder system\n\n"
            "Go to a case, or name one with -case <dir>"
        );
    }
    return dir;
}

void CommandLine::printBanner() const
{
    sph::printBanner(data_->text, data_->caseDir());
}

} // namespace sph
