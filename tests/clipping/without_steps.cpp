// SPDX-License-Identifier: GPL-3.0-or-later
// Copies a source of the library without the calls by which it tells its steps (trace.h): what they
// return stands in their place. watching_test compares the machine code of both.
//
//   without_steps IN OUT
#include <cctype>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

namespace {

/// What stands for a call; # is the argument of that number, from 0.
const std::map<std::string, std::string> instead{{"test", "(#1)"},
                                                 {"let", "(#2)"},
                                                 {"set", "(#1)"},
                                                 {"cut", "void(0)"},
                                                 {"left", "void(0)"},
                                                 {"reject", "std::nullopt"},
                                                 {"giveUp", "std::nullopt"},
                                                 {"accept", "std::optional(#1)"}};

bool isPartOfName(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

/// From behind an opening bracket: the arguments, and `at` behind the closing one.
std::vector<std::string> argumentsAt(const std::string& text, std::size_t& at)
{
    std::vector<std::string> arguments(1);
    for (int depth = 1; at < text.size(); ++at) {
        const char c = text[at];
        depth += (c == '(' || c == '{' || c == '[') - (c == ')' || c == '}' || c == ']');
        if (depth == 0) {
            ++at;
            break;
        }
        if (c == ',' && depth == 1)
            arguments.emplace_back();
        else
            arguments.back() += c;
    }
    return arguments;
}

std::string without(const std::string& text)
{
    static const std::string step = "step.";
    std::string result;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t found = text.find(step, at);
        const bool isWord = found != text.npos && (found == 0 || !isPartOfName(text[found - 1]));
        if (!isWord) {
            const std::size_t end = found == text.npos ? text.size() : found + 1;
            result += text.substr(at, end - at);
            at = end;
            continue;
        }
        std::size_t after = found + step.size();
        while (isPartOfName(text[after]))
            ++after;
        const auto row =
            instead.find(text.substr(found + step.size(), after - found - step.size()));
        if (text[after] != '(') { // a member of a step that was written down
            result += text.substr(at, after - at);
            at = after;
            continue;
        }
        result += text.substr(at, found - at);
        at = after;
        if (row == instead.end()) {
            std::cerr << "Not a word of trace.h: " << text.substr(found, 40) << '\n';
            std::exit(1);
        }
        const std::vector<std::string> arguments = argumentsAt(text, ++at);
        const std::string& form = row->second;
        const std::size_t mark = form.find('#');
        result += mark == form.npos ? form
                                    : form.substr(0, mark)
                                          + without(arguments.at(std::size_t(form[mark + 1] - '0')))
                                          + form.substr(mark + 2);
    }
    return result;
}

} // namespace

int main(int, char** arguments)
{
    std::ifstream in(arguments[1]);
    const std::string text{std::istreambuf_iterator(in), {}};
    std::ofstream(arguments[2]) << without(text);
}
