"""Study the results of a class: which exercises were hard, and which mistakes were common."""
