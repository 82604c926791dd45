"""What a user declares, by family; the methods of `Model`."""
