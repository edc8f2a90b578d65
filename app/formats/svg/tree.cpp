// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/tree.h"

#include "app/base/memory.h"
#include "app/base/text.h"
#include "app/formats/svg/html_entities.h"
#include "app/formats/svg/lenient_xml.h"
#include "app/formats/svg/limits.h"
#include "app/formats/svg/refused.h"
#include "app/formats/svg/scanner.h"

#include <QBuffer>
#include <QStringDecoder>

#include <algorithm>
#include <array>

namespace app::svg {
namespace {

struct Namespace {
    std::string_view uri, prefix;
};
constexpr std::array namespaces{
    Namespace{"http://www.w3.org/2000/svg", ""},
    Namespace{"http://www.w3.org/1999/xlink", "xlink:"},
    Namespace{"http://www.inkscape.org/namespaces/inkscape", "inkscape:"},
    Namespace{"http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd", "sodipodi:"},
    Namespace{"urn:clearcut:1", "clearcut:"},
    Namespace{"http://www.w3.org/1999/xhtml", "html:"},
    Namespace{"http://www.w3.org/XML/1998/namespace", "xml:"},
};

void appendText(std::string& text, std::string_view added)
{
    text += added;
    if (text.size() > mostText)
        throw Refused{Text::tr("it holds more than %1 bytes of text.").arg(mostText),
                      Refused::wholeFile};
}

// Text from the file on one line, shortened, for use in a sentence.
QString quotable(std::string_view text)
{
    constexpr qsizetype most = 80;
    const QString line = QString::fromUtf8(text).simplified();
    return line.size() <= most ? line : line.left(most) + u'…';
}

// The error for a file that is not well-formed XML to its end.
Refused whyNot(const XmlError& error, qint64 line, std::size_t elements)
{
    if (error.kind == XmlError::Kind::Incomplete)
        return elements == 0 ? Refused{Text::tr("it is empty."), Refused::wholeFile}
                             : Refused{Text::tr("is incomplete: the file ends too early."), line};
    if (elements == 0)
        return {Text::tr("it is not an SVG drawing (%1).").arg(error.reason), Refused::wholeFile};
    return {Text::tr("is not correct XML (%1).").arg(error.reason), line};
}

// Thrown where the text is not XML.
struct Malformed {
    XmlError error;
    Refused why;
};

struct HashOfName {
    using is_transparent = void;
    std::size_t operator()(std::string_view name) const
    {
        return std::hash<std::string_view>()(name);
    }
};

} // namespace

class TreeBuilder final : public XmlHandler {
public:
    /// `report` begins with what was passed over so far.
    TreeBuilder(qint64 linesBefore, const Report& report, bool isUtf8)
        : xml_(*this, isUtf8), linesBefore_(linesBefore), report_(report)
    {
    }

    Tree build(QIODevice& in)
    {
        reserve(std::size_t(in.size()));
        try {
            xml_.read(in);
        } catch (const XmlError& error) {
            throw Malformed{error,
                            whyNot(error, linesBefore_ + error.line, tree_.elements_.size())};
        }
        tree_.elements_.push_back({0, noNode, 0, std::uint32_t(tree_.attributes_.size()), 0});
        tree_.attributes_.emplace_back(); // gives the end of the last ones an address
        tree_.elements_.shrink_to_fit();
        tree_.about_ = about_.about();
        tree_.saysTooMuch_ = about_.tooLarge();
        tree_.notesOfElements_ = about_.ofElements();
        return std::move(tree_);
    }

    const Report& report() const { return report_; }

    void take(const XmlToken& token) override
    {
        report_.turnTo(line());
        if (const auto note = about_.take(token))
            addNote(*note);
        if (token.kind == XmlToken::Kind::Start)
            open(token);
        else if (token.kind == XmlToken::Kind::End)
            close();
        else if (token.kind == XmlToken::Kind::Text && inStyle_)
            addStyle(token.text);
        else if (token.kind == XmlToken::Kind::Text && texts_ > 0)
            addText(token.text);
        else if (token.kind == XmlToken::Kind::Instruction
                 && token.name.qualified == "xml-stylesheet")
            report_.add(losses::otherFile);
    }
    void takeUndeclared(std::string_view prefix) override
    {
        report_.turnTo(line());
        report_.add(losses::undeclaredPrefix, prefix);
    }

private:
    qint64 line() const { return linesBefore_ + xml_.line(); }

    /// For a file of lines, whose elements have some 60 bytes. What is not used takes no memory.
    void reserve(std::size_t bytes)
    {
        constexpr std::size_t least = 1000, ofElement = 64, ofAttribute = 20;
        tree_.text_.reserve(std::max(least, std::min(bytes, mostText))); // on the heap, so that
                                                                         // views survive a move
        tree_.elements_.reserve(bytes / ofElement);
        tree_.attributes_.reserve(bytes / ofAttribute);
        tree_.names_ = {otherName};
    }

    void open(const XmlToken& token)
    {
        const auto name = nameIndex(token.name);
        if (tree_.elements_.empty() && tree_.names_[name] != "svg")
            throw Refused{Text::tr("it is not an SVG drawing; its first element is <%1>.")
                              .arg(quotable(token.name.local)),
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
        for (const XmlAttribute& attribute : token.attributes)
            addAttribute(attribute);
        texts_ += tree_.names_[name] == "text";
        openStyle(tree_.names_[name], token);
    }

    void openStyle(std::string_view name, const XmlToken& token)
    {
        report_.add(losses::otherFile, name == "html:link");
        inStyle_ = false;
        if (name != "style" && name != "html:style")
            return;
        const std::string_view type = token.valueOf("type");
        inStyle_ = type.empty() || equalsIgnoringCase(type, "text/css");
        if (inStyle_)
            tree_.styleSheets_.push_back({{}, std::string(token.valueOf("media")), line()});
    }

    void addStyle(std::string_view text)
    {
        StyleText& style = tree_.styleSheets_.back();
        if (style.text.empty())
            style.line = line(); // the tag may have several
        appendText(style.text, text);
    }

    void addAttribute(const XmlAttribute& attribute)
    {
        const auto name = nameIndex(attribute.name);
        if (tree_.names_[name] == otherName)
            return;
        const auto offset = tree_.text_.size();
        appendText(tree_.text_, attribute.value);
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

    void addText(std::string_view text)
    {
        const auto name = intern(textNode);
        const auto end = Node(tree_.elements_.size() + 1);
        const auto offset = std::uint32_t(tree_.text_.size());
        appendText(tree_.text_, text);
        tree_.elements_.push_back({name, open_.back(), end, std::uint32_t(tree_.attributes_.size()),
                                   std::uint32_t(line())});
        tree_.attributes_.push_back({name, std::uint32_t(text.size()), offset});
    }

    void close()
    {
        texts_ -= tree_.name(open_.back()) == "text";
        tree_.elements_[open_.back()].end = Node(tree_.elements_.size());
        open_.pop_back();
        inStyle_ = false;
    }

    std::uint32_t nameIndex(const XmlName& name)
    {
        if (name.uri.empty())
            return intern(name.local);
        const auto known = std::ranges::find(namespaces, name.uri, &Namespace::uri);
        if (known == namespaces.end())
            return intern(otherName);
        if (known->prefix.empty())
            return intern(name.local);
        key_ = known->prefix;
        key_ += name.local;
        return intern(key_);
    }

    std::uint32_t intern(std::string_view name)
    {
        const auto found = indices_.find(name);
        if (found != indices_.end())
            return found->second;
        if (indices_.size() == mostNames)
            return intern(otherName);
        const auto index = std::uint32_t(tree_.names_.size());
        indices_.emplace(name, index);
        tree_.names_.emplace_back(name);
        return index;
    }

    static inline const std::string otherName = "other";

    XmlReader xml_;
    qint64 linesBefore_;
    Report report_;
    Tree tree_;
    std::vector<Node> open_;
    MemoryWatch memory_;
    std::unordered_map<std::string, std::uint32_t, HashOfName, std::equal_to<>> indices_{
        {otherName, 0}};
    std::string key_;
    bool inStyle_ = false;
    int texts_ = 0; ///< open <text> elements
    AboutReader about_;
};

// The file in UTF-8, with the characters of HTML, where this makes the best of an error.
// It begins at `begin`. What cannot be made better is not read again: a device forgets its error.
static std::optional<QByteArray> mended(QIODevice& in, qint64 begin, const XmlError& error,
                                        qint64 linesBefore, Report& report)
{
    if (error.kind == XmlError::Kind::UnknownEncoding) {
        in.seek(begin);
        QStringDecoder decoder(error.encoding.c_str());
        if (!decoder.isValid())
            return {};
        const QString text = decoder(in.readAll());
        return decoder.hasError() ? std::nullopt : std::optional(text.toUtf8());
    }
    if (error.kind != XmlError::Kind::UndefinedEntity)
        return {};
    in.seek(begin);
    const QByteArray text = in.readAll();
    const QByteArray better = withHtmlCharacters(text, error.entities, linesBefore, report);
    return better == text ? std::nullopt : std::optional(better);
}

static Tree built(QIODevice& in, Report& report)
{
    const Beginning beginning = skipBlankBeginning(in);
    if (beginning.lines > 0 || beginning.bytes > 0)
        report.add(losses::blankBeginning);
    QBuffer text;
    QIODevice* from = &in;
    bool isUtf8 = false;
    for (;;) {
        const qint64 begin = from->pos();
        try {
            TreeBuilder builder(beginning.lines, report, isUtf8);
            Tree tree = builder.build(*from);
            report = builder.report();
            return tree;
        } catch (const Malformed& malformed) {
            const auto better = mended(*from, begin, malformed.error, beginning.lines, report);
            if (!better)
                throw Refused(malformed.why);
            isUtf8 = isUtf8 || malformed.error.kind == XmlError::Kind::UnknownEncoding;
            text.close();
            text.setData(*better);
            text.open(QIODevice::ReadOnly);
            from = &text;
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
