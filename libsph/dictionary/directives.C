// #include and its relatives, #inputMode, #remove.

#include "dictionary/files.H"
#include "dictionary/parser.H"

#include <filesystem>
#include <set>

namespace sph
{

void Parser::readDirective(const Token& directive)
{
    const std::string& name = directive.text;
    const auto is = [&](const std::set<word>& names)
    {
        return names.count(name) > 0;
    };
    if
    (
        is
        ({
            "include", "includeIfPresent", "sinclude",
            "includeEtc", "sincludeEtc"
        })
    )
    {
        include(directive);
    }
    else if (is({"if", "ifeq", "else", "endif"}))
    {
        readConditional(directive);
    }
    else if (name == "inputMode")
    {
        setInputMode(directive);
    }
    else if (name == "remove")
    {
        remove(directive);
    }
    else if (is({"eval", "calc"}))
    {
        fail("#" + name + " needs a keyword in front of it", directive.line);
    }
    else
    {
        failUnknown(directive);
    }
}

void Parser::failUnknown(const Token& directive) const
{
    if (directive.text == "codeStream")
    {
        fail
        (
            "#codeStream is not available: code in dictionaries is not "
            "compiled; use #eval{ } for arithmetic",
            directive.line
        );
    }
    const word meant = nearest
    (
        directive.text,
        {
            "include", "includeIfPresent", "sinclude", "includeEtc",
            "sincludeEtc", "inputMode", "remove", "if", "ifeq", "else",
            "endif", "eval", "calc"
        }
    );
    fail
    (
        "Unknown directive '#" + directive.text + "'"
      + (meant.empty() ? "" : "\n did you mean '#" + meant + "'?"),
        directive.line
    );
}

std::string Parser::includeFile(const Token& directive)
{
    namespace fs = std::filesystem;

    const std::string& name = directive.text;
    const bool fromEtc = name == "includeEtc" || name == "sincludeEtc";
    const bool optional =
        name == "includeIfPresent" || name == "sinclude"
     || name == "sincludeEtc";
    if (!fromEtc && !optional && name != "include")
    {
        failUnknown(directive);
    }

    const Token file = in_->next();
    if
    (
        file.kind != Token::Kind::string && file.kind != Token::Kind::word
    )
    {
        fail
        (
            "#" + name + " needs the name of a file in quotes, found "
          + file.description(),
            directive.line
        );
    }
    const fs::path folder =
        fromEtc ? etcFolder() : fs::path(in_->file()).parent_path();
    const fs::path path =
        (folder/expandText(file.text, file.line)).lexically_normal();

    std::error_code ignored;    // of a name that no file can have
    if (!fs::is_regular_file(path, ignored))
    {
        if (optional)
        {
            return "";
        }
        fail
        (
            "Cannot open the file \"" + path.string() + "\" of #" + name
          + (fromEtc && folder.empty() ? ": SPH_ETC is not set" : ""),
            directive.line
        );
    }
    if (++includes_ > 1000)
    {
        fail("More than 1000 files are included", directive.line);
    }
    if (includeDepth_ >= 30)
    {
        fail
        (
            "The file \"" + path.string() + "\" includes itself",
            directive.line
        );
    }
    return path.string();
}

void Parser::include(const Token& directive)
{
    const std::string file = includeFile(directive);
    if (!file.empty())
    {
        ++includeDepth_;
        read(readText(file), file);
        --includeDepth_;
    }
}

void Parser::setInputMode(const Token& directive)
{
    static const std::map<word, InputMode> modes
    {
        {"merge", InputMode::merge},
        {"default", InputMode::merge},
        {"overwrite", InputMode::overwrite},
        {"protect", InputMode::protect},
        {"warn", InputMode::warn},
        {"error", InputMode::error}
    };
    const Token mode = in_->next();
    const auto found = modes.find(mode.text);
    if (mode.kind != Token::Kind::word || found == modes.end())
    {
        fail
        (
            "Unknown #inputMode, found " + mode.description() + "; there are "
            "merge, overwrite, protect, warn, error and default",
            directive.line
        );
    }
    inputMode_ = found->second;
}

void Parser::remove(const Token& directive)
{
    TokenList names{in_->next()};
    if (names[0].is('('))
    {
        names.clear();
        for (Token name = in_->next(); !name.is(')'); name = in_->next())
        {
            names.push_back(name);
            if (name.kind == Token::Kind::end || name.is(';'))
            {
                fail("The list of #remove is not closed", directive.line);
            }
        }
    }
    for (const Token& name : names)
    {
        const bool isPattern = name.kind == Token::Kind::string;
        if (!isPattern && name.kind != Token::Kind::word)
        {
            fail
            (
                "#remove needs keywords, found " + name.description(),
                directive.line
            );
        }
        if (!isPattern)
        {
            here().remove(here().findLiteral(name.text));
            continue;
        }
        const std::regex pattern = compile(name);
        for (const word& keyword : here().literalKeywords())
        {
            if (std::regex_match(keyword, pattern))
            {
                here().remove(here().findLiteral(keyword));
            }
        }
    }
}

} // namespace sph
