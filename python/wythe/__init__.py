"""wythe: how strong masonry is, how far it can drift, how it will fail, and how sure we are.

    import wythe
    result = wythe.run("examples/tuff_wall/model.toml")
    print(result.summary["peak_reaction_kN"], result.summary["failure_mode"]["name"])

Calls: run, check, limit, contact, run_many, campaign, open_campaign, replay. Models: Model. As a function
of numbers: Function, and wythe.openturns, wythe.umbridge, wythe.dakota. Types: wythe.answers. Pictures: wythe.plot.
Exceptions: InputError, AccessError, Interrupted, DefectError, MissingPackage.
"""

from ._calls import campaign, check, contact, limit, open_campaign, replay, run, run_many
from ._errors import AccessError, DefectError, Fault, InputError, Interrupted, MissingPackage, NoAnswer, WytheError
from ._function import Function
from ._jobs import Table
from ._model import Model, Quantity, keys
from ._results import Batch, Campaign, Check, Result, SecondOpinion, State
from ._wythe import version as provenance

__version__ = provenance.split()[1]

__all__ = [
    "run",
    "check",
    "limit",
    "contact",
    "run_many",
    "campaign",
    "open_campaign",
    "replay",
    "keys",
    "Model",
    "Quantity",
    "Function",
    "Table",
    "Result",
    "State",
    "Check",
    "Batch",
    "Campaign",
    "SecondOpinion",
    "Fault",
    "WytheError",
    "InputError",
    "AccessError",
    "DefectError",
    "Interrupted",
    "MissingPackage",
    "NoAnswer",
    "provenance",
    "__version__",
]
