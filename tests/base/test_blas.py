"""Degrees of freedom are chosen in one thread of BLAS; the setting of before returns when the last caller has left."""

from concurrent.futures import ThreadPoolExecutor

from mechanisms import slider_crank
from threadpoolctl import ThreadpoolController

from flexel.base.blas import LIMIT, one_thread


def test_the_setting_of_before_returns() -> None:
    with ThreadpoolController().limit(limits=2, user_api="blas"):
        before = LIMIT.threads()
        with one_thread():
            with one_thread():
                assert set(LIMIT.threads()) == {1}
            assert set(LIMIT.threads()) == {1}
        assert LIMIT.threads() == before
        system = slider_crank("B.x").build()
        with ThreadPoolExecutor(8) as pool:
            list(pool.map(lambda _: system.use_coordinates(["B.x"]), range(100)))
        assert LIMIT.threads() == before
