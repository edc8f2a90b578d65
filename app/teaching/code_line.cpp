// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/code_line.h"

#include <QRegularExpression>
#include <QSet>

namespace app {

namespace {

struct Token {
    enum class Kind : std::uint8_t { Name, Word, Literal, Sign };
    Kind kind;
    QString text;
    bool spaced; ///< there is a space before it
};

bool isWord(const QString& text)
{
    static const QSet<QString> words{"and",  "or",    "not",    "true", "false",
                                     "LEFT", "RIGHT", "BOTTOM", "TOP"};
    return words.contains(text);
}

std::vector<Token> tokensOf(const QString& formula)
{
    static const QRegularExpression token(
        QStringLiteral("(\\s*)(?:([A-Za-z_]\\w*(?:\\[\\w+\\])?)(?=(\\(?))|(\\d[\\w.]*)|"
                       "([<>=!]=|.))"));
    std::vector<Token> tokens;
    for (auto found = token.globalMatch(formula); found.hasNext();) {
        const auto match = found.next();
        const bool spaced = !match.captured(1).isEmpty();
        using Kind = Token::Kind;
        if (const QString name = match.captured(2); !name.isEmpty())
            tokens.push_back(
                {isWord(name) || !match.captured(3).isEmpty() ? Kind::Word : Kind::Name, name,
                 spaced});
        else if (const QString literal = match.captured(4); !literal.isEmpty())
            tokens.push_back({Kind::Literal, literal, spaced});
        else
            tokens.push_back({Kind::Sign, match.captured(5), spaced});
    }
    return tokens;
}

bool isOperand(const Token& token)
{
    return token.kind == Token::Kind::Name || token.kind == Token::Kind::Literal
           || token.text == QStringLiteral(")");
}

/// The bracket that closes the one at `open`; the end of the text if there is none.
qsizetype closing(const QString& text, qsizetype open)
{
    qsizetype depth = 0;
    for (qsizetype at = open; at < text.size(); ++at) {
        depth += (text[at] == u'(') - (text[at] == u')');
        if (depth == 0)
            return at;
    }
    return text.size();
}

/// The arguments of a call, split at the outer commas: "E, F".
QStringList argumentsIn(const QString& text)
{
    QStringList arguments{QString()};
    qsizetype depth = 0;
    for (const QChar c : text) {
        depth += (c == u'(') - (c == u')');
        if (c == u',' && depth == 0)
            arguments << QString();
        else
            arguments.last() += c;
    }
    for (QString& argument : arguments)
        argument = argument.trimmed();
    return arguments;
}

/// Adds the assignments of a call: each parameter of the definition gets its argument.
void appendCalls(std::vector<Assignment>& all, const QString& line, const QStringList& code)
{
    static const QRegularExpression defines(QStringLiteral("^\\s*(\\w+)\\(([\\w, ]+)\\):$"));
    for (const QString& definition : code) {
        const auto match = defines.match(definition);
        if (!match.hasMatch() || line == definition)
            continue;
        const auto call =
            QRegularExpression(QStringLiteral("\\b%1\\(").arg(match.captured(1))).match(line);
        if (!call.hasMatch())
            continue;
        const qsizetype open = call.capturedEnd() - 1;
        const QStringList given =
                              argumentsIn(line.sliced(open + 1, closing(line, open) - open - 1)),
                          names = argumentsIn(match.captured(2));
        for (qsizetype i = 0; i < std::min(given.size(), names.size()); ++i)
            all.push_back({names[i], given[i], true});
    }
}

/// A line without the head of a one-line function: "notL(): if x1 < xmin: reject".
QString bodyOf(const QString& line)
{
    static const QRegularExpression head(QStringLiteral("^\\w+\\([\\w, ]*\\): +"));
    return line.trimmed().remove(head);
}

/// The statement of a line, without condition or "else"; "if r > u1: reject" and "else" have none.
QString statementOf(const QString& line)
{
    static const QRegularExpression leads(
        QStringLiteral("^(?:else )?(?:if|while|until) .*?(?<! ):(?= )|^else(?: |$)"));
    return bodyOf(line).remove(leads).trimmed();
}

} // namespace

QString conditionIn(const QString& line)
{
    static const QRegularExpression asks(
        QStringLiteral("^(?:else )?(?:if|while|until) (.*?)(?:(?<! ):(?: .*)?)?$"));
    return asks.match(bodyOf(line)).captured(1);
}

std::vector<Assignment> assignmentsIn(const QString& line, const QStringList& code)
{
    static const QRegularExpression sets(QStringLiteral("^(\\w+(?:\\[\\w+\\])?) = (.+)$"));
    std::vector<Assignment> all;
    for (const QString& part : statementOf(line).split(QStringLiteral(",  ")))
        if (const auto match = sets.match(part.trimmed()); match.hasMatch())
            all.push_back({match.captured(1), match.captured(2)});
    appendCalls(all, line, code);
    return all;
}

QStringList namesIn(const QString& formula)
{
    QStringList names;
    for (const Token& token : tokensOf(formula))
        if (token.kind == Token::Kind::Name)
            names << token.text;
    return names;
}

QString withTexts(const QString& formula, const std::function<QString(const QString& name)>& text)
{
    static const QString minus = QStringLiteral("\u2212");
    QString result;
    const Token* before = nullptr;
    const auto tokens = tokensOf(formula);
    for (const Token& token : tokens) {
        const bool isSum = token.text == QStringLiteral("+") || token.text == QStringLiteral("-");
        const bool isBinary = isSum && before && isOperand(*before);
        QString word = token.kind == Token::Kind::Name     ? text(token.text)
                       : token.text == QStringLiteral("-") ? minus
                                                           : token.text;
        const bool isBehindOperator = before && before->kind == Token::Kind::Sign
                                      && QStringLiteral("+-*/|&~").contains(before->text);
        if (token.kind == Token::Kind::Name && word.startsWith(minus) && isBehindOperator)
            word = QStringLiteral("(%1)").arg(word);
        const bool apart = isBinary || token.spaced;
        if (apart && !result.isEmpty() && !result.endsWith(u' '))
            result += u' ';
        result += word;
        if (isBinary)
            result += u' ';
        before = &token;
    }
    return result.trimmed();
}

} // namespace app
