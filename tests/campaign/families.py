"""All families of models: strategies of hypothesis that draw a `Case`."""

from hypothesis.strategies import SearchStrategy

from campaign.calls import Case

FAMILIES: dict[str, SearchStrategy[Case]] = {}
