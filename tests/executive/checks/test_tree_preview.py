import types

import pytest
from py_trees.behaviours import Success

from executive.checks import tree_preview
from executive.errors import UserError
from trees.nodes.alternatives import Alternatives
from trees.tasks import SayTask


def test_a_tree_that_cannot_be_written_is_told_with_the_judgement_that_has_no_name(monkeypatch):
    def too_stiff(failure):
        return True

    root = Alternatives("bow", [Success("lean")], hopeless=too_stiff)
    monkeypatch.setattr(tree_preview, "build_tree", lambda task, toolbox: types.SimpleNamespace(root=root))

    words = r"^the tree of 'say' cannot be written: bow: hopeless: .*too_stiff.*@judgement"
    with pytest.raises(UserError, match=words):
        tree_preview.preview_document(SayTask("say hello", "hello"))
