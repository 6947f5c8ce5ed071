"""The robot in a browser: what it believes, its tree and its reasons, and a line to command it by."""
