"""Compare our models with pymunk: how long does each take to reach a given accuracy?"""
