// SPDX-License-Identifier: GPL-3.0-or-later
// The matrices are those of CSS Color 4, section 18.
#include "app/formats/svg/colour_spaces.h"

#include "app/formats/svg/scanner.h"

#include <cmath>
#include <numbers>

namespace app::svg {
namespace {

using Parts3 = std::array<double, 3>;
using Matrix3 = std::array<Parts3, 3>;

Parts3 times(const Matrix3& m, const Parts3& v)
{
    Parts3 result{};
    for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t i = 0; i < 3; ++i)
            result[row] += m[row][i] * v[i];
    return result;
}

constexpr Matrix3 d50ToD65{{{0.955473421488075, -0.02309845494876471, 0.06325924320057072},
                            {-0.0283697093338637, 1.0099953980813041, 0.021041441191917323},
                            {0.012314014864481998, -0.020507649298898964, 1.330365926242124}}};
constexpr Matrix3 xyzToLinear{{{3.2409699419045213, -1.5373831775700935, -0.4986107602930033},
                               {-0.9692436362808798, 1.8759675015077206, 0.04155505740717561},
                               {0.05563007969699361, -0.20397695888897657, 1.0569715142428786}}};
constexpr Matrix3 p3ToXyz{{{0.48657094864821626, 0.26566769316909294, 0.1982172852343625},
                           {0.22897456406974884, 0.6917385218365062, 0.079286914093745},
                           {0.0, 0.045113381858902575, 1.0439443689009757}}};
constexpr Matrix3 oklabToLms{{{1, 0.3963377773761749, 0.2158037573099136},
                              {1, -0.1055613458156586, -0.0638541728258133},
                              {1, -0.0894841775298119, -1.2914855480194092}}};
constexpr Matrix3 lmsToXyz{{{1.2268798758459243, -0.5578149944602171, 0.2813910456659647},
                            {-0.0405757452148008, 1.1122868032803170, -0.0717110580655164},
                            {-0.0763729366746601, -0.4214933324022432, 1.5869240198367816}}};

double encoded(double linear)
{
    const double size = std::abs(linear);
    const double part = size <= 0.0031308 ? 12.92 * size : 1.055 * std::pow(size, 1 / 2.4) - 0.055;
    return std::copysign(part, linear);
}
double decoded(double part)
{
    const double size = std::abs(part);
    const double linear = size <= 0.04045 ? size / 12.92 : std::pow((size + 0.055) / 1.055, 2.4);
    return std::copysign(linear, part);
}

Parts3 each(double (*change)(double), const Parts3& v)
{
    return {change(v[0]), change(v[1]), change(v[2])};
}

SrgbParts ofXyz(const Parts3& xyz) { return each(encoded, times(xyzToLinear, xyz)); }

} // namespace

SrgbParts srgbOfLab(const std::array<double, 3>& lab)
{
    constexpr double kappa = 24389.0 / 27, epsilon = 216.0 / 24389;
    constexpr Parts3 white{0.3457 / 0.3585, 1, (1 - 0.3457 - 0.3585) / 0.3585};
    const double y = (lab[0] + 16) / 116, x = lab[1] / 500 + y, z = y - lab[2] / 200;
    const auto cubed = [](double f) {
        return f * f * f > epsilon ? f * f * f : (116 * f - 16) / kappa;
    };
    const double high = lab[0] > kappa * epsilon ? y * y * y : lab[0] / kappa;
    return ofXyz(times(d50ToD65, {cubed(x) * white[0], high * white[1], cubed(z) * white[2]}));
}

SrgbParts srgbOfOklab(const std::array<double, 3>& lab)
{
    Parts3 lms = times(oklabToLms, lab);
    for (double& part : lms)
        part = part * part * part;
    return ofXyz(times(lmsToXyz, lms));
}

std::array<double, 3> fromPolar(const std::array<double, 3>& lch)
{
    const double hue = lch[2] * std::numbers::pi / 180;
    return {lch[0], lch[1] * std::cos(hue), lch[1] * std::sin(hue)};
}

std::optional<SrgbParts> srgbOfSpace(std::string_view space, const std::array<double, 3>& parts)
{
    const auto is = [&](std::string_view name) { return equalsIgnoringCase(space, name); };
    if (is("srgb"))
        return parts;
    if (is("srgb-linear"))
        return each(encoded, parts);
    if (is("display-p3"))
        return ofXyz(times(p3ToXyz, each(decoded, parts)));
    if (is("xyz") || is("xyz-d65"))
        return ofXyz(parts);
    if (is("xyz-d50"))
        return ofXyz(times(d50ToD65, parts));
    return std::nullopt;
}

} // namespace app::svg
