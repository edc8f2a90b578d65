// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/style.h"

#include "app/base/text.h"
#include "app/formats/svg/limits.h"
#include "app/formats/svg/property.h"
#include "app/formats/svg/refused.h"
#include "app/formats/svg/report.h"
#include "app/formats/svg/scanner.h"

#include <algorithm>
#include <array>

namespace app::svg {

Properties Properties::inherited() const
{
    Properties child = *this;
    const Properties initial;
    child.opacity = initial.opacity;
    child.displayed = initial.displayed;
    child.overflowShown = initial.overflowShown;
    child.overflowGiven = initial.overflowGiven;
    child.fixedWidth = initial.fixedWidth;
    child.maskByAlpha = initial.maskByAlpha;
    child.transform = {};
    child.clipPath = child.mask = child.filter = child.blending = {};
    child.stopColour = initial.stopColour;
    child.stopOpacity = initial.stopOpacity;
    child.shape.clear();
    child.alignment = {};
    child.baselineShift = 0;
    child.script = Script::None;
    child.text.linesAround |= child.text.lines;
    child.text.lines = 0;
    return child;
}

std::string_view lengthText(const Tree& tree, Node node, const Properties& properties,
                            std::string_view name)
{
    const auto& set = properties.shape;
    const auto found = std::find_if(set.rbegin(), set.rend(),
                                    [&](const ShapeValue& one) { return one.name == name; });
    return found == set.rend() ? tree.attribute(node, name) : found->value;
}

namespace {

constexpr std::string_view styleName = "style", fontName = "font";

bool isFontSize(const Property& property)
{
    return property.name == fontName || property.name == "font-size";
}

bool isVariable(const Declaration& declaration) { return declaration.property.starts_with("--"); }

} // namespace

// The style of one element, as far as it is computed.
struct Styles::Cascade {
    Node node;
    const Properties& parent;
    Lengths lengths;
    Properties result;
    std::vector<std::span<const Declaration>> declarations; ///< from the weakest to the strongest
    bool ofFonts = false; ///< whether the size of the font is set, and nothing else
};

Styles::Styles(const Tree& tree, Report& report)
    : tree_(tree), report_(report), sheet_(tree, report)
{
    for (std::uint32_t name = 0; name < tree.nameCount(); ++name) {
        using Kind = AttributeEffect::Kind;
        const std::string& text = tree.nameOf(name);
        const Property* property = findProperty(text);
        if (property && property->attribute == Property::Attribute::Other)
            property = nullptr;
        const AttributeEffect effect = effectOf(text);
        const bool isTold =
            !property && (effect.kind == Kind::Lost || effect.kind == Kind::Unknown);
        attributes_.push_back({property, effect, isTold, text == styleName});
    }
}

Properties Styles::of(Node node, const Properties& parent, const Lengths& lengths)
{
    Cascade cascade{node, parent, lengths, parent.inherited(), {}};
    cascade.lengths.fontSize = parent.fontSize;
    const auto own = parseDeclarations(styleAttribute(node));
    if (!sheet_.empty())
        for (const auto* rule : sheet_.matching(node))
            cascade.declarations.emplace_back(*rule);
    if (!own.empty())
        cascade.declarations.emplace_back(own);
    const auto line = report_.line();
    report_.turnTo(tree_.line(node));
    applyVariables(cascade);
    if (setsFont(cascade)) { // first, because lengths in em refer to its size
        cascade.ofFonts = true;
        applyAll(cascade);
        cascade.ofFonts = false;
        cascade.lengths.fontSize = cascade.result.fontSize;
    }
    applyAll(cascade);
    report_.turnTo(line);
    return std::move(cascade.result);
}

bool Styles::setsFont(const Cascade& cascade) const
{
    const auto begins = [](const Declaration& declaration) {
        return equalsIgnoringCase(declaration.property.substr(0, fontName.size()), fontName);
    };
    return std::any_of(tree_.begin(cascade.node), tree_.last(cascade.node),
                       [&](const auto& attribute) {
                           const Property* property = attributes_[attribute.name].property;
                           return property && isFontSize(*property);
                       })
           || std::ranges::any_of(cascade.declarations, [&](const auto& declarations) {
                  return std::ranges::any_of(declarations, begins);
              });
}

void Styles::applyAll(Cascade& cascade)
{
    applyAttributes(cascade);
    for (const bool important : {false, true})
        for (const auto& declarations : cascade.declarations)
            for (const Declaration& declaration : declarations)
                if (declaration.important == important && !isVariable(declaration))
                    apply(cascade, declaration);
}

std::string_view Styles::styleAttribute(Node node)
{
    for (auto attribute = tree_.begin(node); attribute != tree_.last(node); ++attribute)
        if (attributes_[attribute->name].isStyle)
            return uncommented(*attribute);
    return {};
}

void Styles::applyVariables(Cascade& cascade)
{
    if (cascade.declarations.empty())
        return;
    Variables variables{cascade.parent.variables, {}};
    for (const bool important : {false, true})
        for (const auto& declarations : cascade.declarations)
            for (const Declaration& declaration : declarations)
                if (declaration.important == important && isVariable(declaration))
                    variables.own[declaration.property] = declaration.value;
    if (!variables.own.empty())
        cascade.result.variables = std::make_shared<const Variables>(std::move(variables));
}

void Styles::applyAttributes(Cascade& cascade)
{
    for (auto attribute = tree_.begin(cascade.node); attribute != tree_.last(cascade.node);
         ++attribute) {
        const auto& [property, effect, isTold, isStyle] = attributes_[attribute->name];
        if (isTold && !cascade.ofFonts)
            tell(effect, tree_.nameOf(attribute->name), tree_.valueOf(*attribute));
        if (!property || isFontSize(*property) != cascade.ofFonts)
            continue;
        const auto value = trimmed(uncommented(*attribute));
        if (property->attribute == Property::Attribute::Same || usesVariables(value))
            set(cascade, *property, value, false);
    }
}

void Styles::tell(const AttributeEffect& effect, std::string_view name, std::string_view value)
{
    const bool isLost = effect.kind == AttributeEffect::Kind::Lost;
    const bool isPlain = std::ranges::any_of(wordsOf(effect.without), [&](std::string_view word) {
        return equalsIgnoringCase(word, trimmed(value));
    });
    if (!isPlain)
        report_.add(isLost ? losses::attribute : losses::unknownAttribute, name);
}

void Styles::apply(Cascade& cascade, const Declaration& declaration)
{
    const Meaning& meaning = meaningOf(declaration.property);
    if (meaning.property) {
        // `font` in its turn, too: it resets what stands before it.
        if (isFontSize(*meaning.property) == cascade.ofFonts || meaning.property->name == fontName)
            set(cascade, *meaning.property, declaration.value, true);
    } else if (!cascade.ofFonts && !meaning.lost.empty()
               && isLost(meaning.lost, declaration.value, cascade.node == 0)) {
        report_.add(losses::property, meaning.lost);
    }
}

const Styles::Meaning& Styles::meaningOf(std::string_view name)
{
    const auto [at, isNew] = meanings_.try_emplace(name);
    if (isNew) {
        std::string plain = plainName(name);
        at->second.property = findProperty(plain);
        if (!at->second.property && !hasNoEffect(plain))
            at->second.lost = std::move(plain);
    }
    return at->second;
}

// A value that is not understood changes nothing.
void Styles::set(Cascade& cascade, const Property& property, std::string_view value, bool isCss)
{
    const auto is = [&](std::string_view word) { return equalsIgnoringCase(value, word); };
    if (value.empty())
        return;
    const double fontSize = cascade.result.fontSize;
    const bool refers = usesVariables(value);
    const std::string_view written = value;
    if (refers)
        value = withVariables(value, cascade);
    const bool unset = is("unset") || is("revert") || is("revert-layer");
    const bool inherits = is("inherit") || (unset && property.inherited);
    if (property.copy && (inherits || unset || is("initial")))
        property.copy(cascade.result, inherits ? cascade.parent : Properties());
    else if (!property.set(cascade.result, value, {property.name, cascade.lengths, isCss})
             && !(cascade.ofFonts && property.name == fontName)) // which is set again
        report_.add(losses::value, std::string(property.name) + ": " + std::string(written));
    else
        report_.add(losses::profileColour, value.find(" icc-color(") != value.npos);
    if (!cascade.ofFonts)
        cascade.result.fontSize = fontSize; // that of `font` is set already
}

// The value with its variables replaced; a property with an unknown one is not set.
std::string_view Styles::withVariables(std::string_view value, const Cascade& cascade)
{
    const Substituted made = substituted(value, cascade.result.variables.get());
    const auto [at, isNew] = texts_.emplace(trimmed(made.text.value_or("unset")));
    variableWork_ += made.work + (isNew ? at->size() : 0);
    if (variableWork_ > mostVariableWork)
        throw Refused{Text::tr("its style sheet is too large for so many elements."),
                      Refused::wholeFile};
    return *at;
}

std::string_view Styles::uncommented(const Tree::Attribute& attribute)
{
    const auto value = tree_.valueOf(attribute);
    if (value.find("/*") == value.npos)
        return value;
    const auto [known, isNew] = uncommented_.try_emplace(attribute.offset);
    if (isNew)
        known->second = withoutComments(value, 1);
    return known->second;
}

} // namespace app::svg
