// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/tree.h"

#include "app/base/memory.h"
#include "app/base/text.h"
#include "app/formats/svg/html_entities.h"
#include "app/formats/svg/lenient_xml.h"
#include "app/formats/svg/limits.h"
#include "app/formats/svg/refused.h"
#include "app/formats/svg/scanner.h"

#include <QXmlStreamReader>

#include <algorithm>
#include <array>

namespace app::svg {
namespace {

struct Namespace {
    QLatin1StringView uri;
    std::string_view prefix;
};
constexpr std::array namespaces{
    Namespace{QLatin1StringView("http://www.w3.org/2000/svg"), ""},
    Namespace{QLatin1StringView("http://www.w3.org/1999/xlink"), "xlink:"},
    Namespace{QLatin1StringView("http://www.inkscape.org/namespaces/inkscape"), "inkscape:"},
    Namespace{QLatin1StringView("http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd"), "sodipodi:"},
    Namespace{QLatin1StringView("urn:clearcut:1"), "clearcut:"},
    Namespace{QLatin1StringView("http://www.w3.org/1999/xhtml"), "html:"},
};

void appendUtf8(std::string& text, QStringView added)
{
    const auto ascii = std::ranges::all_of(added, [](QChar c) { return c.unicode() < 0x80; });
    if (ascii)
        std::ranges::transform(added, std::back_inserter(text), &QChar::toLatin1);
    else
        text += added.toUtf8().toStdString();
    if (text.size() > mostText)
        throw Refused{Text::tr("it holds more than %1 bytes of text.").arg(mostText),
                      Refused::wholeFile};
}

// Text from the file on one line, shortened, for use in a sentence.
QString quotable(QStringView text)
{
    constexpr qsizetype most = 80;
    const QString line = text.toString().simplified();
    return line.size() <= most ? line : line.left(most) + u'…';
}

// The error for a file that is not well-formed XML to its end.
Refused whyNot(const QXmlStreamReader& xml, qint64 line, std::size_t elements)
{
    if (xml.error() == QXmlStreamReader::PrematureEndOfDocumentError)
        return elements == 0 ? Refused{Text::tr("it is empty."), Refused::wholeFile}
                             : Refused{Text::tr("is incomplete: the file ends too early."), line};
    QString reason = quotable(xml.errorString());
    while (reason.endsWith(u'.'))
        reason.chop(1);
    if (elements == 0)
        return {Text::tr("it is not an SVG drawing (%1).").arg(reason), Refused::wholeFile};
    return {Text::tr("is not correct XML (%1).").arg(reason), line};
}

// Thrown where the text is not XML.
struct Malformed {
    Refused why;
};

} // namespace

class TreeBuilder {
public:
    /// `report` begins with what was passed over so far.
    TreeBuilder(QIODevice& in, const Beginning& beginning, const UsedPrefixes& undeclared,
                const Report& report)
        : xml_(&in), linesBefore_(beginning.lines), report_(report),
          entities_(xml_, linesBefore_, report_)
    {
        tree_.text_.reserve(1000); // on the heap, so that views of it survive a move
        tree_.names_ = {otherName};
        xml_.setEntityResolver(&entities_);
        for (const auto& [prefix, used] : undeclared)
            xml_.addExtraNamespaceDeclaration({prefix, used.uri});
    }

    Tree build()
    {
        while (!xml_.atEnd() && !xml_.hasError()) // after a read error there is no end
            take(xml_.readNext());
        if (xml_.hasError())
            throw Malformed{whyNot(xml_, line(), tree_.elements_.size())};
        tree_.elements_.push_back({0, noNode, 0, std::uint32_t(tree_.attributes_.size()), 0});
        tree_.attributes_.emplace_back(); // gives the end of the last ones an address
        tree_.elements_.shrink_to_fit();
        tree_.about_ = about_.about();
        tree_.saysTooMuch_ = about_.tooLarge();
        tree_.notesOfElements_ = about_.ofElements();
        return std::move(tree_);
    }

    const Report& report() const { return report_; }

private:
    qint64 line() const { return linesBefore_ + xml_.lineNumber(); }

    void take(QXmlStreamReader::TokenType token)
    {
        report_.turnTo(line());
        if (const auto note = about_.take(xml_))
            addNote(*note);
        if (token == QXmlStreamReader::StartElement)
            open();
        else if (token == QXmlStreamReader::EndElement)
            close();
        else if (token == QXmlStreamReader::Characters && inStyle_)
            appendUtf8(tree_.styleSheets_.back().text, xml_.text());
        else if (token == QXmlStreamReader::ProcessingInstruction
                 && xml_.processingInstructionTarget() == QLatin1StringView("xml-stylesheet"))
            report_.add(losses::otherFile);
    }

    void open()
    {
        const auto name = nameIndex(xml_.namespaceUri(), xml_.name());
        if (tree_.elements_.empty() && tree_.names_[name] != "svg")
            throw Refused{Text::tr("it is not an SVG drawing; its first element is <%1>.")
                              .arg(quotable(xml_.name())),
                          Refused::wholeFile};
        if (open_.size() == deepestNesting)
            throw Refused{Text::tr("nests elements deeper than %1; ungroup some of them.")
                              .arg(deepestNesting),
                          line()};
        if (!memory_.isEnough())
            throw Refused{memoryEnds(), line()};
        const Node parent = open_.empty() ? noNode : open_.back();
        open_.push_back(Node(tree_.elements_.size()));
        tree_.elements_.push_back(
            {name, parent, 0, std::uint32_t(tree_.attributes_.size()), std::uint32_t(line())});
        for (const QXmlStreamAttribute& attribute : xml_.attributes())
            addAttribute(attribute);
        openStyle(tree_.names_[name]);
    }

    void openStyle(std::string_view name)
    {
        report_.add(losses::otherFile, name == "html:link");
        inStyle_ = false;
        if (name != "style" && name != "html:style")
            return;
        const QXmlStreamAttributes attributes = xml_.attributes();
        const auto type = attributes.value(QLatin1StringView("type"));
        const auto media = attributes.value(QLatin1StringView("media")).toString();
        inStyle_ =
            type.isEmpty() || type.compare(QLatin1StringView("text/css"), Qt::CaseInsensitive) == 0;
        if (inStyle_)
            tree_.styleSheets_.push_back({{}, media.toStdString(), line()});
    }

    void addAttribute(const QXmlStreamAttribute& attribute)
    {
        const auto name = nameIndex(attribute.namespaceUri(), attribute.name());
        if (tree_.names_[name] == otherName)
            return;
        const auto offset = tree_.text_.size();
        appendUtf8(tree_.text_, attribute.value());
        tree_.attributes_.push_back(
            {name, std::uint32_t(tree_.text_.size() - offset), std::uint32_t(offset)});
    }

    // Call while the note's own element is still open.
    void addNote(const ElementNote& note)
    {
        Notes& notes = tree_.notes_[open_.end()[-2]];
        QString& text = note.isTitle ? notes.title : notes.description;
        text += text.isEmpty() ? note.text : u'\n' + note.text;
        ++notes.count;
    }

    void close()
    {
        tree_.elements_[open_.back()].end = Node(tree_.elements_.size());
        open_.pop_back();
        inStyle_ = false;
    }

    std::uint32_t nameIndex(QStringView uri, QStringView local)
    {
        std::string_view prefix;
        if (!uri.empty()) {
            const auto found = std::ranges::find_if(
                namespaces, [&](const Namespace& known) { return known.uri == uri; });
            if (found == namespaces.end())
                return intern(otherName);
            prefix = found->prefix;
        }
        key_ = prefix;
        appendUtf8(key_, local);
        return intern(key_);
    }

    std::uint32_t intern(const std::string& name)
    {
        if (indices_.size() == mostNames && !indices_.contains(name))
            return intern(otherName);
        const auto [at, isNew] = indices_.try_emplace(name, std::uint32_t(tree_.names_.size()));
        if (isNew)
            tree_.names_.push_back(name);
        return at->second;
    }

    static inline const std::string otherName = "other";

    QXmlStreamReader xml_;
    qint64 linesBefore_;
    Report report_;
    HtmlEntities entities_;
    Tree tree_;
    std::vector<Node> open_;
    MemoryWatch memory_;
    std::unordered_map<std::string, std::uint32_t> indices_{{otherName, 0}};
    std::string key_;
    bool inStyle_ = false;
    AboutReader about_;
};

// Builds the tree, with declarations for the prefixes that the file uses without any.
static Tree built(QIODevice& in, Report& report)
{
    const Beginning beginning = skipBlankBeginning(in);
    if (beginning.lines > 0 || beginning.bytes > 0)
        report.add(losses::blankBeginning);
    const auto build = [&](const UsedPrefixes& undeclared) {
        TreeBuilder builder(in, beginning, undeclared, report);
        Tree tree = builder.build();
        report = builder.report();
        return tree;
    };
    const qint64 begin = in.pos();
    try {
        return build({});
    } catch (const Malformed& malformed) {
        in.seek(begin);
        const UsedPrefixes undeclared = undeclaredPrefixes(in);
        if (undeclared.empty())
            throw Refused(malformed.why);
        in.seek(begin);
        for (const auto& [prefix, used] : undeclared) {
            report.turnTo(beginning.lines + used.line);
            report.add(losses::undeclaredPrefix, prefix.toStdString());
        }
        try {
            return build(undeclared);
        } catch (const Malformed& further) {
            throw Refused(further.why);
        }
    }
}

Tree Tree::read(QIODevice& in, Report& report)
{
    if (const QString fault = memoryFault(std::uint64_t(in.size())); !fault.isEmpty())
        throw Refused{fault, Refused::wholeFile}; // a tree is larger than its file
    Tree tree = built(in, report);
    for (Node node = 0; node + 1 < tree.elements_.size(); ++node)
        if (const auto id = tree.attribute(node, "id"); !id.empty())
            tree.ids_.try_emplace(id, node);
    return tree;
}

const Tree::Attribute* Tree::findAttribute(Node node, std::string_view name) const
{
    const auto found = std::find_if(begin(node), last(node), [&](const Attribute& attribute) {
        return names_[attribute.name] == name;
    });
    return found == last(node) ? nullptr : found;
}

std::string_view Tree::attribute(Node node, std::string_view name) const
{
    const Attribute* const found = findAttribute(node, name);
    return found ? valueOf(*found) : std::string_view();
}

bool Tree::hasAttribute(Node node, std::string_view name) const
{
    return findAttribute(node, name) != nullptr;
}

const Notes& Tree::notesOf(Node node) const
{
    static const Notes none;
    const auto found = notes_.find(node);
    return found == notes_.end() ? none : found->second;
}

Node Tree::find(std::string_view id) const
{
    const auto found = ids_.find(id);
    return found == ids_.end() ? noNode : found->second;
}

std::string_view hrefOf(const Tree& tree, Node node)
{
    const auto href = tree.attribute(node, "href");
    return href.empty() ? tree.attribute(node, "xlink:href") : href;
}

// The address in "url(#id)", "#id" or "url('#id')".
static std::string_view addressOf(std::string_view reference)
{
    reference = trimmed(reference);
    if (equalsIgnoringCase(reference.substr(0, 4), "url(") && reference.ends_with(')'))
        reference = trimmed(reference.substr(4, reference.size() - 5));
    const auto isQuote = [](char c) { return c == '"' || c == '\''; };
    if (reference.size() >= 2 && isQuote(reference.front())
        && reference.back() == reference.front())
        reference = trimmed(reference.substr(1, reference.size() - 2));
    return reference;
}

bool isElsewhere(std::string_view reference)
{
    const auto address = addressOf(reference);
    return !address.empty() && !address.starts_with('#');
}

Node Tree::findReference(std::string_view reference) const
{
    const auto address = addressOf(reference);
    return address.starts_with('#') ? find(address.substr(1)) : noNode;
}

} // namespace app::svg
