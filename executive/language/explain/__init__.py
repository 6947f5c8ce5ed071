"""Why a sentence is refused, and what works in its place."""
