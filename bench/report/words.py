"""Numbers for people: three digits, commas between thousands, powers of ten, plurals."""
import math

NONE = "–"
_RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


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
