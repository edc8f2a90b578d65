// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/svg/about.h"

#include <QIODevice>

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace app::svg {

/// An element, identified by its number in document order; 0 is the root.
using Node = std::uint32_t;
constexpr Node noNode = ~Node(0);

/// The title and description of an element as XML, and the number of elements that they come from.
struct Notes {
    QString title, description;
    int count = 0;
};

/// The text of a <style> element.
struct StyleText {
    std::string text{}, media{};
    qint64 line = 0; ///< of the file, where it begins
};

class Report;

/// The name of a piece of text inside a <text>, which is stored as an element; the attribute of the
/// same name has it.
constexpr std::string_view textNode = "#text";

/// The elements of a file and their attributes, stored compactly: 100,000 lines take about as much
/// memory as their file. Of text only that of <text> and of style sheets is kept. Elements of SVG's
/// namespace have no prefix. Names of Inkscape, Sodipodi, XLink and Clearcut get their usual prefix
/// ("inkscape:label"); names of other namespaces become "other".
class Tree {
public:
    /// Reads a file, a device with random access. Common errors of well-formedness are passed over
    /// and reported. Throws Refused for others, if the file is not SVG, or beyond the limits.
    /// External entities are never fetched.
    static Tree read(QIODevice& in, Report& report);

    Tree(Tree&&) = default;

    struct Attribute {
        std::uint32_t name; ///< for nameOf()
        std::uint32_t length;
        std::uint32_t offset;
    };

    std::size_t size() const { return elements_.size() - 1; } ///< the number of elements
    std::string_view name(Node node) const { return names_[elements_[node].name]; }
    Node parent(Node node) const { return elements_[node].parent; } ///< noNode for the root
    /// The end of the descendants, which is where the next sibling begins.
    Node end(Node node) const { return elements_[node].end; }
    qint64 line(Node node) const { return elements_[node].line; }

    /// "" if the attribute is missing.
    std::string_view attribute(Node node, std::string_view name) const;
    bool hasAttribute(Node node, std::string_view name) const; ///< also true for an empty attribute
    const Attribute* begin(Node node) const { return &attributes_[elements_[node].attributes]; }
    const Attribute* last(Node node) const { return &attributes_[elements_[node + 1].attributes]; }
    std::string_view valueOf(const Attribute& attribute) const
    {
        return std::string_view(text_).substr(attribute.offset, attribute.length);
    }
    const std::string& nameOf(std::uint32_t name) const { return names_[name]; }
    std::size_t nameCount() const { return names_.size(); }
    std::size_t textSize() const { return text_.size(); } ///< bytes of all attributes

    /// The <style> elements in CSS.
    const std::vector<StyleText>& styleSheets() const { return styleSheets_; }

    const About& about() const { return about_; }
    /// Whether the file's own title, description and metadata exceeded `mostMetadata`; then they
    /// are not kept.
    bool saysTooMuch() const { return saysTooMuch_; }
    /// The number of titles, descriptions and metadata of elements below the root.
    int notesOfElements() const { return notesOfElements_; }
    /// The title and description of an element below the root, except those that are too large.
    const Notes& notesOf(Node node) const;

    /// The first element with this id, or noNode.
    Node find(std::string_view id) const;
    /// The target of "url(#id)", "#id" or "url('#id')".
    Node findReference(std::string_view reference) const;

private:
    friend class TreeBuilder;
    Tree() = default;
    const Attribute* findAttribute(Node node, std::string_view name) const; ///< null if missing
    struct Element {
        std::uint32_t name;
        Node parent, end;
        std::uint32_t attributes; ///< the first one; the next element's is the end
        std::uint32_t line;
    };
    std::vector<Element> elements_; ///< and a final element, which ends the attributes
    std::vector<Attribute> attributes_;
    std::vector<std::string> names_;
    std::string text_;
    std::vector<StyleText> styleSheets_;
    std::unordered_map<std::string_view, Node> ids_;
    std::unordered_map<Node, Notes> notes_;
    About about_;
    bool saysTooMuch_ = false;
    int notesOfElements_ = 0;
};

/// Whether a reference, as "url(other.svg#id)" or "other.svg#id", names another file.
bool isElsewhere(std::string_view reference);

/// "href", or the older "xlink:href".
std::string_view hrefOf(const Tree& tree, Node node);

/// The children of an element, for range-based loops.
class Children {
public:
    Children(const Tree& tree, Node parent) : tree_(tree), parent_(parent) {}

    struct Iterator {
        const Tree* tree;
        Node node;
        Node operator*() const { return node; }
        Iterator& operator++() { return node = tree->end(node), *this; }
        friend bool operator==(const Iterator& a, const Iterator& b) { return a.node == b.node; }
    };
    Iterator begin() const { return {&tree_, parent_ + 1}; }
    Iterator end() const { return {&tree_, tree_.end(parent_)}; }

private:
    const Tree& tree_;
    Node parent_;
};

} // namespace app::svg
