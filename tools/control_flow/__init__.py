"""What BehaviorTree.CPP itself does with random trees, recorded."""
