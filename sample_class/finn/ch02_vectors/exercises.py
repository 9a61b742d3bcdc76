"""Finn's exercises."""


def scalar_product_and_angle(a, b):
    product = a.dot(b)
    if product > 0:
        return product, "acute"
    if product < 0:
        return product, "obtuse"
    return product, "right"
