// #if #ifeq #else #endif, and #eval.

#include "dictionary/expressionValue.H"
#include "dictionary/parser.H"
#include "dictionary/switchWord.H"

#include <algorithm>

namespace sph
{

void Parser::readConditional(const Token& directive)
{
    if (directive.text == "if" || directive.text == "ifeq")
    {
        conditionals_.push_back(directive.line);
        if (!condition(directive))
        {
            skipBranch(directive.line, true);
        }
        return;
    }
    if (conditionals_.size() == outerConditionals_)
    {
        fail
        (
            "#" + directive.text + " without an #if before it", directive.line
        );
    }
    if (directive.text == "else")
    {
        skipBranch(conditionals_.back(), false);
    }
    else
    {
        conditionals_.pop_back();
    }
}

bool Parser::condition(const Token& directive)
{
    TokenList tokens;
    while
    (
        in_->peek().kind != Token::Kind::end
     && in_->peek().line == directive.line
    )
    {
        const Token token = in_->next();
        TokenList expanded{token};
        if (token.kind == Token::Kind::variable)
        {
            expanded = expand(token);
        }
        else if (token.kind == Token::Kind::directive)
        {
            expanded.clear();
            readValueDirective(token, expanded);
        }
        tokens.insert(tokens.end(), expanded.begin(), expanded.end());
    }

    if (directive.text == "ifeq")
    {
        if (tokens.size() != 2)
        {
            fail
            (
                "#ifeq compares two words or numbers, found '"
              + tokenText(tokens) + "'",
                directive.line
            );
        }
        const bool numbers =
            tokens[0].kind == Token::Kind::number
         && tokens[1].kind == Token::Kind::number;
        return numbers
          ? tokens[0].value == tokens[1].value
          : tokens[0].text == tokens[1].text;
    }
    const auto value =
        tokens.size() == 1 ? switchValue(tokens[0]) : std::nullopt;
    if (!value)
    {
        fail
        (
            "#if needs one switch such as yes, no, on, off, true, false, "
            "found '" + tokenText(tokens) + "'",
            directive.line
        );
    }
    return *value;
}

// Leaves the #if open at its #else, or closes it at its #endif
void Parser::skipBranch(const label opened, const bool toElse)
{
    label depth = 0;
    while (true)
    {
        const Token token = in_->next();
        if (token.kind == Token::Kind::end)
        {
            fail("This #if is not closed by #endif", opened);
        }
        if (token.kind != Token::Kind::directive)
        {
            continue;
        }
        if (token.text == "if" || token.text == "ifeq")
        {
            ++depth;
        }
        else if (token.text == "endif" && depth-- == 0)
        {
            conditionals_.pop_back();
            return;
        }
        else if (token.text == "else" && depth == 0 && toElse)
        {
            return;
        }
    }
}

ExpressionValue Parser::variableValue
(
    const std::string& name, const label line
) const
{
    return expressionValue(name, variableTokens(name, line));
}

TokenList Parser::evaluateHere(const Token& directive)
{
    std::string text;
    label line = directive.line;
    if (!in_->bracedText(text, line))
    {
        const Token quotedText = in_->next();
        if
        (
            quotedText.kind != Token::Kind::string
         && quotedText.kind != Token::Kind::verbatim
        )
        {
            fail
            (
                "#" + directive.text + " needs { expression }, found "
              + quotedText.description(),
                directive.line
            );
        }
        text = withoutComments(quotedText.text);
        line = quotedText.line;
    }

    try
    {
        const ExpressionValue result = evaluate
        (
            text,
            [&](const std::string& name) { return variableValue(name, line); }
        );
        TokenList tokens;
        for (std::size_t i = 0; i < (result.isVector ? 3 : 1); ++i)
        {
            tokens.push_back(Token::number(result.v[i], line));
        }
        if (result.isVector)
        {
            tokens.insert(tokens.begin(), Token::punctuation('(', line));
            tokens.push_back(Token::punctuation(')', line));
        }
        return tokens;
    }
    catch (const ExpressionError& error)
    {
        const auto begin = text.begin();
        fail
        (
            "In the expression '" + text + "': " + error.what(),
            line + std::count(begin, begin + error.offset(), '\n')
        );
    }
}

} // namespace sph
