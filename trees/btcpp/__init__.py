"""Trees as documents of BehaviorTree.CPP: kinds of nodes, reader, writer."""
