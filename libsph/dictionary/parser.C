#include "dictionary/parser.H"

#include "dictionary/keywordPattern.H"

#include <iostream>

namespace sph
{

void Parser::fail
(
    const std::string& message, const label startLine, const label endLine
) const
{
    const std::string& scope = here().scope;
    throw IOError
    (
        message,
        in_->file() + (scope.empty() ? "" : "." + scope),
        startLine,
        endLine
    );
}

std::regex Parser::compile(const Token& pattern) const
{
    try
    {
        return keywordPattern(pattern.text);
    }
    catch (const std::invalid_argument& error)
    {
        fail
        (
            "The keyword " + quoted(pattern.text) + ' ' + error.what(),
            pattern.line
        );
    }
}

void Parser::read(const std::string& text, const std::string& file)
{
    Tokeniser tokens(text, file);
    Tokeniser* const outer = in_;
    in_ = &tokens;
    readEntries(nullptr);
    here().endLine = outer ? here().endLine : tokens.line();
    in_ = outer;
}

void Parser::readEntries(const Opening* const opening)
{
    const std::size_t outerConditionals = outerConditionals_;
    outerConditionals_ = conditionals_.size();

    for (bool open = true; open; )
    {
        const Token token = in_->next();
        switch (token.kind)
        {
            case Token::Kind::word:
            case Token::Kind::string:
                readEntry(token);
                break;
            case Token::Kind::variable:
                expandEntries(token);
                break;
            case Token::Kind::directive:
                readDirective(token);
                break;
            case Token::Kind::end:
                if (opening)
                {
                    fail
                    (
                        "The '{' of dictionary '" + opening->keyword
                      + "' is not closed by '}'",
                        opening->startLine,
                        opening->endLine
                    );
                }
                open = false;
                break;
            case Token::Kind::number:
                fail
                (
                    "Expected a keyword, found " + token.description()
                  + "; a keyword cannot start with a digit",
                    token.line
                );
            default:
                open = !(token.is('}') && opening);
                if (open && token.is('}'))
                {
                    fail("Unexpected '}': no dictionary is open", token.line);
                }
                if (open && !token.is(';'))
                {
                    fail
                    (
                        "Expected a keyword, found " + token.description(),
                        token.line
                    );
                }
        }
    }

    if (conditionals_.size() > outerConditionals_)
    {
        fail("This #if is not closed by #endif", conditionals_.back());
    }
    outerConditionals_ = outerConditionals;
}

void Parser::readEntry(const Token& keyword)
{
    if (keyword.text.size() > maxKeyword)
    {
        fail
        (
            "A keyword of " + std::to_string(keyword.text.size())
          + " characters is too long; it begins with '"
          + keyword.text.substr(0, 40) + "'",
            keyword.line
        );
    }
    auto entry = std::make_unique<Entry>();
    entry->keyword = keyword.text;
    entry->file = in_->file();
    entry->startLine = keyword.line;
    entry->endLine = keyword.line;
    if (keyword.kind == Token::Kind::string)
    {
        entry->pattern = compile(keyword);
    }

    if (in_->peek().is('{'))
    {
        entry->endLine = in_->next().line;
        readDictionary(std::move(entry));
        return;
    }

    entry->tokens = readValue(entry.get());
    entry->endLine = in_->line();
    const bool isMacroDictionary =
        !entry->tokens.empty() && entry->tokens[0].block;
    if (isMacroDictionary && entry->tokens.size() > 1)
    {
        fail
        (
            "Entry '" + entry->keyword + "' is a dictionary: nothing can stand"
            " behind it, found " + entry->tokens[1].description(),
            entry->startLine
        );
    }
    if (isMacroDictionary)
    {
        const auto block = std::move(entry->tokens[0].block);
        entry->tokens.clear();
        entry->dict = Contents::of(*block).clone
        (
            here().subScope(entry->keyword)
        );
    }
    store(std::move(entry));
}

void Parser::checkDepth(const label line) const
{
    if (scopes_.size() > 100 || here().scope.size() > 2000)
    {
        fail("The dictionaries are nested too deeply", line);
    }
}

void Parser::readDictionary(std::unique_ptr<Entry> entry)
{
    checkDepth(entry->startLine);
    entry->dict = Contents::make
    (
        in_->file(), here().subScope(entry->keyword)
    );
    Contents::of(*entry->dict).startLine = entry->startLine;

    const Opening opening
    {
        entry->keyword, entry->startLine, entry->endLine
    };
    const bool kept = admits(*entry);
    Entry* const target = kept ? place(std::move(entry)) : entry.get();

    scopes_.push_back(&Contents::of(*target->dict));
    readEntries(&opening);
    if (target->file == in_->file())
    {
        target->endLine = in_->line();
        here().endLine = in_->line();
    }
    scopes_.pop_back();
}

// Errors: IOError if the entry is a duplicate where none is allowed
bool Parser::admits(const Entry& entry) const
{
    // The header of an included file says nothing about this one
    if (includeDepth_ > 0 && entry.keyword == "FoamFile")
    {
        return false;
    }
    const Entry* const present = here().findLiteral
    (
        entry.keyword, bool(entry.pattern)
    );
    if (!present || inputMode_ == InputMode::merge)
    {
        return true;
    }
    const std::string duplicate =
        "duplicate entry: " + entry.keyword + ", first given on line "
      + std::to_string(present->startLine);
    if (inputMode_ == InputMode::error)
    {
        fail(duplicate, entry.startLine);
    }
    if (inputMode_ == InputMode::warn)
    {
        std::cerr << "--> FOAM Warning : " << entry.file << " at line "
            << entry.startLine << ": " << duplicate << '\n';
    }
    return inputMode_ == InputMode::overwrite;
}

// Puts an entry into this dictionary and returns where it stands
Entry* Parser::place(std::unique_ptr<Entry> entry)
{
    const word keyword = entry->keyword;
    const bool isPattern = bool(entry->pattern);
    if (inputMode_ == InputMode::overwrite)
    {
        here().remove(here().findLiteral(keyword, isPattern));
    }
    here().insert(std::move(entry));
    return here().findLiteral(keyword, isPattern);
}

void Parser::store(std::unique_ptr<Entry> entry)
{
    if (admits(*entry))
    {
        place(std::move(entry));
    }
}

} // namespace sph
