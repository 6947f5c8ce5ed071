"""One estimate of a thing from several senses, each with its covariance; where they disagree is told."""
