# SPDX-License-Identifier: MIT
"""The matrices of dual quaternions, and the arithmetic of section 10 in single precision, step by step.

A list of numbers is one number a bone: all bones of a row go through each step together.
"""
import struct


def rounded(numbers):
    """Numbers rounded to single precision, each as a step of the arithmetic of section 10 leaves it."""
    return struct.unpack(f"<{len(numbers)}f", struct.pack(f"<{len(numbers)}f", *numbers))


def f32_sum(*terms):
    """The sums of lists, from left to right, rounded at each step."""
    total = terms[0]
    for term in terms[1:]:
        total = rounded([a + b for a, b in zip(total, term)])
    return total


def f32_product(a, b):
    return rounded([x * y for x, y in zip(a, b)])


def f32_difference(a, b):
    return rounded([x - y for x, y in zip(a, b)])


def f32_quotient(a, b):
    return rounded([x / y for x, y in zip(a, b)])


def f32_dot(a, b):
    return f32_sum(*(f32_product(x, y) for x, y in zip(a, b)))


def f32_blend(a, b, factor):
    """a (1 - f) + b f."""
    rest = f32_difference([1.0] * len(factor), factor)
    return f32_sum(f32_product(a, rest), f32_product(b, factor))


SMALLEST_SQUARE = rounded([1e-12])[0]


def without_scale(numbers, length):
    """Real part, d' and s, nine lists, of the eight numbers of bone-rows."""
    real, dual = numbers[0:4], numbers[4:8]
    one, two = [1.0] * len(real[0]), [2.0] * len(real[0])
    along = f32_quotient(f32_dot(real, dual), f32_dot(real, real))
    scale = f32_sum(one, f32_quotient(f32_product(two, along), [length] * len(one)))
    return [*real, *(f32_difference(d, f32_product(along, r)) for r, d in zip(real, dual)), scale]


def matrices(parts):
    """Twelve lists, of what without_scale gives or a blend of it."""
    x, y, z, w, dx, dy, dz, dw, scale = parts
    one, two = [1.0] * len(x), [2.0] * len(x)
    square = f32_dot((x, y, z, w), (x, y, z, w))
    h = f32_quotient(two, [max(number, SMALLEST_SQUARE) for number in square])

    def diagonal(a, b):
        return f32_product(scale, f32_difference(one, f32_product(h, f32_sum(f32_product(a, a), f32_product(b, b)))))

    def beside(a, b, c, combine):
        return f32_product(scale, f32_product(h, combine(f32_product(a, b), f32_product(w, c))))

    def moved(d, a, cross_a, cross_b):
        turned = f32_difference(f32_product(w, d), f32_product(dw, a))
        return f32_product(h, f32_sum(turned, f32_difference(f32_product(*cross_a), f32_product(*cross_b))))

    return [diagonal(y, z), beside(x, y, z, f32_difference), beside(x, z, y, f32_sum), moved(dx, x, (y, dz), (z, dy)),
            beside(x, y, z, f32_sum), diagonal(x, z), beside(y, z, x, f32_difference), moved(dy, y, (z, dx), (x, dz)),
            beside(x, z, y, f32_difference), beside(y, z, x, f32_sum), diagonal(x, y), moved(dz, z, (x, dy), (y, dx))]


def dualquat_matrices(numbers, length):
    """Section 10 for all bones of a row at once: eight lists in, twelve out."""
    return matrices(without_scale(numbers, length))


def blended_dualquat_matrices(first, second, factor, length):
    """The same between two rows; each bone has its own factor."""
    a, b = without_scale(first, length), without_scale(second, length)
    return matrices([f32_blend(one, other, factor) for one, other in zip(a, b)])
