// What stands between a keyword and its ';'.

#include "dictionary/files.H"
#include "dictionary/parser.H"

namespace sph
{

TokenList Parser::readValue(const Entry* const entry)
{
    TokenList tokens;
    TokenList open;
    while (true)
    {
        const Token token = in_->next();
        const bool ends =
            token.kind == Token::Kind::end || token.is(';')
         || (token.is('}') && (open.empty() || !open.back().is('{')));
        if (ends && !open.empty())
        {
            failUnclosed(open.back(), entry);
        }
        if (entry ? token.is(';') : token.kind == Token::Kind::end)
        {
            return tokens;
        }
        if (ends && entry)
        {
            failMissingSemicolon(*entry, tokens);
        }
        if (ends)
        {
            fail("Unexpected " + token.description(), token.line);
        }
        if (!readPart(token, entry, tokens))
        {
            balance(token, entry, open);
            tokens.push_back(token);
        }
    }
}

// Whatever is more than the token itself: a macro, a directive, a dictionary
bool Parser::readPart
(
    const Token& token, const Entry* const entry, TokenList& into
)
{
    const bool repeats =
        !into.empty() && into.back().kind == Token::Kind::number;
    if (token.kind == Token::Kind::variable)
    {
        const TokenList expanded = expand(token);
        into.insert(into.end(), expanded.begin(), expanded.end());
    }
    else if (token.kind == Token::Kind::directive)
    {
        readValueDirective(token, into);
    }
    else if (token.is('{') && !repeats)
    {
        readBlock(token, entry, into);
    }
    else
    {
        return false;
    }
    return true;
}

void Parser::balance
(
    const Token& token, const Entry* const entry, TokenList& open
) const
{
    if (token.is('(') || token.is('{'))
    {
        open.push_back(token);
    }
    if (!token.is(')') && !token.is('}'))
    {
        return;
    }
    if (open.empty())
    {
        fail
        (
            "Unexpected '" + token.text + "'"
          + (entry ? " in entry '" + entry->keyword + "'" : ""),
            token.line
        );
    }
    if (open.back().is('(') != token.is(')'))
    {
        failUnclosed(open.back(), entry);
    }
    open.pop_back();
}

void Parser::failUnclosed
(
    const Token& bracket, const Entry* const entry
) const
{
    fail
    (
        "The '" + bracket.text + "' opened here"
      + (entry ? " in entry '" + entry->keyword + "'" : "")
      + " is not closed",
        bracket.line
    );
}

void Parser::readBlock
(
    const Token& brace, const Entry* const entry, TokenList& into
)
{
    checkDepth(brace.line);
    Opening opening{"", brace.line, brace.line};
    if (!into.empty() && into.back().kind == Token::Kind::word)
    {
        opening.keyword = into.back().text;
        opening.startLine = into.back().line;
    }
    std::string scope = entry ? here().subScope(entry->keyword) : here().scope;
    if (!opening.keyword.empty())
    {
        scope += (scope.empty() ? "" : ".") + opening.keyword;
    }

    Token block;
    block.kind = Token::Kind::block;
    block.line = brace.line;
    block.block = Contents::make(in_->file(), scope);
    Contents& contents = Contents::of(*block.block);
    contents.startLine = opening.startLine;

    scopes_.push_back(&contents);
    readEntries(&opening);
    contents.endLine = in_->line();
    scopes_.pop_back();
    into.push_back(block);
}

void Parser::readValueDirective(const Token& directive, TokenList& into)
{
    const std::string& name = directive.text;
    TokenList tokens;
    if (name == "eval" || name == "calc")
    {
        tokens = evaluateHere(directive);
    }
    else if (name.compare(0, 7, "include") == 0 || name == "sinclude")
    {
        const std::string file = includeFile(directive);
        if (!file.empty())
        {
            Tokeniser included(readText(file), file);
            Tokeniser* const outer = in_;
            in_ = &included;
            ++includeDepth_;
            tokens = readValue(nullptr);
            --includeDepth_;
            in_ = outer;
        }
    }
    else
    {
        failUnknown(directive);
    }
    into.insert(into.end(), tokens.begin(), tokens.end());
}

void Parser::failMissingSemicolon
(
    const Entry& entry, const TokenList& tokens
) const
{
    // Probably at the end of the first line that could end the entry
    label line = tokens.empty() ? entry.startLine : tokens.front().line;
    const label last = tokens.empty() ? line : tokens.back().line;
    label depth = 0;
    for (const Token& token : tokens)
    {
        if (depth == 0 && token.line > line)
        {
            break;
        }
        line = token.line;
        depth += token.is('(') - token.is(')');
    }
    fail
    (
        "Entry '" + entry.keyword + "' is not ended by ';'", line, last
    );
}

} // namespace sph
