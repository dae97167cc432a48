#include "annotation/Exploration.H"

#include "annotation/Silence.H"

#include <deque>

namespace sph
{

namespace
{

// A text to be read, and what was changed in it last: the scope around the
// entry, and the entry with its value
struct Trial
{
    std::string text;
    wordList scope;
    word entry;
    std::string condition;
};


class Explorer
{
    const DictionaryReader& read_;
    std::deque<Trial> trials_;

public:
    ReadEntries entries;

    Explorer(const std::string& text, const DictionaryReader& read)
    :
        read_(read),
        trials_{{text, {}, "", ""}}
    {
        while (!trials_.empty())
        {
            const Trial trial = trials_.front();
            trials_.pop_front();
            follow(trial);
        }
    }

private:
    // Whatever is asked before an error counts, too
    void follow(const Trial& trial)
    {
        const dictionary dict = dictionary::filledIn(trial.text, "sample");
        try
        {
            const Silence silence;
            read_(dict);
        }
        catch (const Error&)
        {
            if (trial.condition.empty())
            {
                throw;
            }
        }
        collect(dict, trial, {}, entries);
    }

    void collect
    (
        const dictionary& dict, const Trial& trial, const wordList& scope,
        ReadEntries& into
    )
    {
        auto& contents = dictionary::Contents::of(dict);
        for (const Lookup& lookup : contents.lookups)
        {
            const word& name = lookup.key.name;
            ReadEntry* known = merge(contents, trial, scope, lookup, into);
            const auto absent = contents.absent.find(name);
            const Entry* const entry = contents.findLiteral(name);
            const dictionary* const below =
                entry ? entry->dict.get()
              : absent != contents.absent.end() ? absent->second.get()
              : nullptr;
            if (below)
            {
                wordList deeper = scope;
                deeper.push_back(name);
                if (!known->isDict && trial.entry != name)
                {
                    known->condition = conditionOf(trial, scope);
                }
                known->isDict = true;
                if (!entry && lookup.key.sample.empty())
                {
                    known->optional = false;    // as good as empty
                }
                collect(*below, trial, deeper, known->entries);
            }
        }
    }

    ReadEntry* merge
    (
        const dictionary::Contents& contents, const Trial& trial,
        const wordList& scope, const Lookup& lookup, ReadEntries& into
    )
    {
        const Entry* const entry = contents.findLiteral(lookup.key.name);
        for (ReadEntry& known : into)
        {
            if (known.lookup.key.name != lookup.key.name)
            {
                continue;
            }
            if
            (
                known.lookup.kind.empty()
             && (!lookup.kind.empty() || known.lookup.key.meaning.empty())
            )
            {
                known.lookup = lookup;      // what it is, by now
            }
            if (lookup.kind.empty() || sameKind(known.lookup, lookup))
            {
                addCondition(trial, known);
                return &known;
            }
        }
        ReadEntry added{lookup};
        added.optional = lookup.kind.empty() && !entry;
        added.value =
            !lookup.key.sample.empty() ? lookup.key.sample
          : entry ? typed(entry->tokens)
          : lookup.defaultValue.value_or("");
        added.condition = conditionOf(trial, scope);
        tryOthers(trial.text, scope, added, entry);
        // Beside the one of this name
        auto at = into.end();
        for (auto known = into.begin(); known != into.end(); ++known)
        {
            if (known->lookup.key.name == lookup.key.name)
            {
                at = known + 1;
            }
        }
        return &*into.insert(at, added);
    }

    static std::string typed(const TokenList& tokens)
    {
        std::string text = tokenText(tokens, TokenStyle::asTyped);
        for (const char* bracket : {"( ", " )"})
        {
            for (std::size_t i; (i = text.find(bracket)) != text.npos; )
            {
                text.erase(bracket[0] == ' ' ? i : i + 1, 1);
            }
        }
        return text;
    }

    // What stands in a dictionary that was added needs none
    static std::string conditionOf(const Trial& trial, const wordList& scope)
    {
        return trial.scope.size() >= scope.size() ? trial.condition : "";
    }

    // Another value of the entry that the condition is about
    static void addCondition(const Trial& trial, ReadEntry& known)
    {
        const auto blank = trial.condition.find(' ');
        if
        (
            known.condition.empty() || blank == std::string::npos
         || known.condition.compare(0, blank, trial.condition, 0, blank) != 0
        )
        {
            return;
        }
        const std::string value = trial.condition.substr(blank);
        if ((known.condition + ' ').find(value + ' ') == std::string::npos)
        {
            known.condition += " or" + value;
        }
    }

    // A default with a sample beside it is another in every case
    static bool sameKind(const Lookup& a, const Lookup& b)
    {
        const bool sameDefault =
            a.key.sample.empty()
          ? a.defaultValue == b.defaultValue
          : bool(a.defaultValue) == bool(b.defaultValue);
        return
            a.kind == b.kind && a.dims == b.dims && a.choices == b.choices
         && a.range.str() == b.range.str() && sameDefault;
    }

    void tryOthers
    (
        const std::string& text, const wordList& scope,
        const ReadEntry& entry, const bool given
    )
    {
        const Lookup& lookup = entry.lookup;
        const word& name = lookup.key.name;
        const auto add = [&](const std::string& value, const bool isDict)
        {
            std::string change =
                name + ' ' + value + (isDict ? " " : "; ");
            for (auto outer = scope.rbegin(); outer != scope.rend(); ++outer)
            {
                change = *outer + " { " + change + "} ";
            }
            trials_.push_back
            ({
                text + ' ' + change, scope, name,
                lookup.kind.empty() ? name : name + ' ' + value
            });
        };
        if (lookup.kind == "yes or no")
        {
            add(entry.value == "yes" ? "no" : "yes", false);
        }
        for (const word& choice : lookup.choices)
        {
            if (choice != entry.value)
            {
                add(choice, false);
            }
        }
        const std::string& sample = lookup.key.sample;
        if (lookup.kind.empty() && !given && !sample.empty())
        {
            add(sample, sample[0] == '{');
        }
    }
};

} // namespace


ReadEntries explore(const std::string& text, const DictionaryReader& read)
{
    return Explorer(text, read).entries;
}

} // namespace sph
