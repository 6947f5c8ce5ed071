"""The trajectory checker on trial: motions with and without defects, and an independent judge."""
