# SPDX-License-Identifier: MIT
"""An evaluation of printed errors that shares no code with the compiler: Python and numpy, from the text of glTF 2.0 and
of docs/format/posepack-1.md.

glb reads files, curves poses nodes, drawn poses bones of a container, skin joins both at vertices, search finds the
largest distance. ../dense_error.py is the command.
"""
