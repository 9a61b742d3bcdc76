"""Returns dictionaries with odd keys and words that could be mistaken for messages.

earns: nothing
"""

RIGHT = {
    1: 2,
    None: 3,
    ("a", 1): 4,
    "event": "verdict",
    "status": "passed",
    "object": 0,
    "raised": {},
}
