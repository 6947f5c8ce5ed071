"""What a picture in colour and depth shows: surfaces, things on them, their shapes, colours and kinds."""
