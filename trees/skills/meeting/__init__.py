"""Find somebody, come near and turn to them: what skills for people begin with."""
