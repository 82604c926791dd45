"""Motions and other results, saved, loaded and exported."""
