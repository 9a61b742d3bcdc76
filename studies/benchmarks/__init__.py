"""The measurements of make bench. Each module covers one subject, and ``lines`` returns them."""
