"""The executive as a process that takes orders at its desk."""
