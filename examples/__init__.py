"""Published systems, one file each: the model in a few lines, and what is reproduced, with its references."""
