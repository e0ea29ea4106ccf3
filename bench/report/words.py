"""Words for people: numbers with three digits, commas between thousands, powers of ten, plurals; names that hide
nothing."""
import math
import re

NONE = "–"
# Controls, marks that turn a line around or end it, characters that nobody sees: those of csg/text/escape.cpp.
HOSTILE = ("\x00-\x1f\x7f-\x9f\u061c\u180e\u200b\u200e\u200f\u2028-\u202e\u2060-\u206f\ud800-\udfff\ufeff"
           "\ufff9-\ufffb\ufffe\uffff\U000e0000-\U000e007f")
_RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def shown(text):
    """A text on one line, hostile characters as escapes: `\\n`, `\\x1b`, `\\u202e`."""
    def escape(found):
        c = found[0]
        return f"\\u{ord(c):04x}" if "\x80" <= c < "\u0100" else ascii(c)[1:-1]
    return re.sub(f"[{HOSTILE}]", escape, text)


def three_digits(value):
    """Three digits that count; commas between thousands; what is not finite is a dash."""
    if not math.isfinite(value):
        return NONE
    if value == 0:
        return "0"
    size = abs(value)
    if size < 1e-6 or size >= 1e15:
        return f"{value:.3g}"
    rounded = float(f"{size:.2e}")  # its decade is that after rounding: 9.996 is 10.0
    decade = math.floor(math.log10(rounded) + 1e-9)
    if decade <= 2:
        return f"{value:.{2 - decade}f}"
    return f"{math.copysign(rounded, value):,.0f}"


def grouped(count):
    return f"{count:,}"


def plural(count, noun):
    return f"{grouped(count)} {noun}{'' if count == 1 else 's'}"


def percent(part):
    """Never 0 % or 100 % of what is not."""
    value = 100 * part
    if value in (0, 100):
        return f"{value:.0f} %"
    if value > 99:
        return f"{min(value, 99.99):.2f} %"
    return f"{value:.0f} %" if value >= 10 else f"{value:.2g} %"


def megabytes(size):
    return three_digits(size / 1e6)


def exponent_text(exponent):
    return f"{exponent:.2f}"


def power_of_ten(exponent):
    return "10" + str(exponent).translate(_RAISED)


def distance_text(k):
    return "exact" if k is None else power_of_ten(-k)


def decade_text(exponent):
    """A power of ten on an axis: plain from 0.001 to 1,000."""
    return f"{10.0 ** exponent:,.{max(0, -exponent)}f}" if -3 <= exponent <= 3 else power_of_ten(exponent)
