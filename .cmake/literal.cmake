# Writes the content of the file `from` as a literal to the file `to`.
file(READ ${from} text)
file(WRITE ${to} "R\"text(${text})text\"\n")
