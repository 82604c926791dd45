"""The users' elements and laws of the campaign; importing this module compiles them."""

from campaign import pool, pool_hard

STRUT, CAM, SKATE = pool.strut(), pool.cam(), pool.skate()
MAXWELL, DRIVER = pool.maxwell(), pool_hard.driver()
