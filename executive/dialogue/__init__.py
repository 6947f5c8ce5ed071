"""Questions and their answers: who is asked, and what an answer settles."""
