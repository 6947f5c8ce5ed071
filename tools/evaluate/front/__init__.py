"""Transcripts of a language model in front: good ones, bad ones, free speech, from a scripted server."""
