"""People in a picture: where they are, how they are, what their arms do, and the colours that they wear."""
