# SPDX-License-Identifier: MIT
"""The rules that a table of results obeys, and the sentences that explain where it parts from a validator.

A row of a table: file, exit code, issue id ("-" when it bakes), verdict, sentence. The verdict is that of the
official glTF validator, as the assets' README gives it:
  valid    no error and no warning      warned  warnings only      error  at least one error
  none     the validator was not asked, crashed, or refused the file
"""

import json
import os
import re
import struct

NOT_COUNTED = "-"
EXIT_OK, EXIT_MALFORMED, EXIT_UNSUPPORTED, EXIT_LIMIT = 0, 3, 5, 6
EXIT_OF_CATEGORY = {"ok": 0, "io": 2, "malformed_glb": 3, "malformed_catalog": 4, "unsupported": 5, "limit": 6,
                    "bad_container": 7, "mismatch": 8, "internal": 70, "usage": 1, "interrupted": 130}
# What may be said of a file in which nothing moves: that, or what makes the rest unreadable.
STILL_ISSUES = {"E-GLB-NO-ANIMATION", "E-GLB-MORPH-ONLY", "E-GLB-URI", "E-GLB-EXTENSION", "E-GLB-VERSION"}

# Why a file that the validator faults is refused as unsupported, not as malformed.
UNSUPPORTED = {
    "E-GLB-NO-ANIMATION": "Nothing in it moves, which is said whatever else is wrong with it.",
    "E-GLB-MORPH-ONLY": "Only morph targets move, and no palette can hold them, whatever else is wrong.",
    "E-GLB-NO-MESH": "It has no mesh that a palette could move, whatever else is wrong.",
    "E-GLB-NO-EXTENT": "The posed mesh has no size, so that no error could be measured against it.",
    "E-GLB-URI": "Its buffer lies outside the GLB, which is refused before anything behind it is read.",
    "E-GLB-EXTENSION": "It requires an extension that is not read, so that the rest cannot be judged.",
    "E-GLB-VERSION": "Another version of glTF has other rules, so that the rest cannot be judged.",
    "E-GLB-INTERPOLATION": "The validator only warns of an unknown interpolation; no sampler could play it.",
}

# Why single files of invalid/ bake, or are refused though the validator finds no error.
INVALID = {
    "d_dup_channel.glb": "The last channel on a target wins, with a warning.",
    "d_interp_unknown.glb": UNSUPPORTED["E-GLB-INTERPOLATION"],
    "d_joint_is_mesh.glb": "A joint may be the mesh's own node: its transform is a joint's, and the mesh ignores it.",
    "d_joint_repeated.glb": "Equal pairs of joint and inverse bind matrix become one bone.",
    "d_name_number.glb": "A name that is no text is no name: the node gets one from its number.",
    "d_skeleton_oob.glb": "skin.skeleton takes no part in skinning (glTF 2.0 section 3.7.3.1), so it is not read.",
    "d_weights_nan.glb": "NaN weights are zeroed and the rest renormalised, with a warning; refused with --strict.",
    "d_weights_negative.glb": "Negative weights are zeroed and the rest renormalised, with a warning; refused with "
                              "--strict.",
    "d_weights_path_no_morph.glb": "A channel of morph weights moves no node: it is left out, with a warning.",
    "d_weights_zero.glb": "A vertex without weights takes those of its nearest neighbour, with a warning; refused "
                          "with --strict.",
    "d_ext_required_unknown.glb": "The validator accepts unknown required extensions; a reader must not (glTF 2.0 "
                                  "section 3.12).",
    "v_glb__extra_data.glb": "The validator only warns of bytes after the declared end: they mark a damaged transfer, "
                             "or hide another file.",
}

# Refusals of features/ and animals/, by id: what the README's row of the file must hold, and the sentence.
FEATURES = [
    ("E-GLB-NO-ANIMATION", r"\|\s*\|[^|]*\|[^|]*\|[^|]*\|$|no clip|no animation", "The file holds no animation."),
    ("E-GLB-MORPH-ONLY", r"morph", "Only morph targets move, and no palette can hold them."),
    ("E-GLB-EXTENSION", r"KHR_draco|EXT_meshopt", "It requires a compression that this build does not read."),
    ("E-GLB-URI", r"fallback", "Its fallback buffer lies outside the GLB."),
    ("E-GLB-NO-MESH", r"\| - \| 0 \| 0 \| 0 \|", "It has no vertices."),
    ("E-GLB-IBM", r"IBM 4th row is not 0,0,0,1", "Its inverse bind matrices are not affine."),
    ("E-GLB-ACCESSOR-COUNT", r"no key|without keys|without target node", "A sampler has no key: accessors hold at "
                             "least one element (glTF 2.0 section 5.1.3)."),
    ("E-LIM-HALF-RANGE", r"very large units", "Translations leave the range of half floats; --texel-format rgba32f "
                         "bakes it."),
]
# Refusals that the README does not foresee.
FEATURES_EXCEPTIONS = {
    "blender_23_multi_prim_vertex_attribute.glb": "Its sparse output drives morph weights: no node moves.",
    "unassigned_skeleton.glb": "Its first inverse bind matrix ends in 0 0 0 0 and holds denormal numbers: it is no "
                               "affine matrix.",
}


def issue_exits(project):
    """Exit code of every issue id, from the issue table."""
    with open(os.path.join(project, "src", "base", "issue_table.def"), encoding="utf-8") as file:
        rows = re.findall(r'^POSEPACK_ISSUE\(\w+, "([EW]-[A-Z0-9-]+)", \w+, (\w+),', file.read(), re.MULTILINE)
    return {name: EXIT_OF_CATEGORY[category] for name, category in rows}


def verdict_of(text):
    """The validator's verdict in a cell of the README of invalid/."""
    found = re.search(r"\[validator: ([^\]]*)\]", text) or re.match(r"Validator: (.*)", text)
    said = found.group(1) if found else ""
    if not said or "CRASHED" in said or said == "REFUSED":
        return "none"
    if said.startswith("valid") or said == "no error":
        return "valid"
    return "warned" if said.startswith("W:") else "error"


def _moves_node(target):
    if target.get("path") == "pointer":
        pointer = target["extensions"]["KHR_animation_pointer"]["pointer"]
        return re.fullmatch(r"/nodes/\d+/(translation|rotation|scale)", pointer) is not None
    return "node" in target and target.get("path") in ("translation", "rotation", "scale")


def moves(path):
    """Whether a channel of the GLB names a node's translation, rotation or scale; None when that cannot be told."""
    with open(path, "rb") as file:
        data = file.read()
    try:
        size = struct.unpack_from("<4sIIII", data)[3]
        document = json.loads(data[20:20 + size].decode())
        targets = [channel["target"] for animation in document.get("animations", [])
                   for channel in animation.get("channels", [])]
        return any(_moves_node(target) for target in targets)
    except (struct.error, ValueError, KeyError, TypeError, AttributeError, RecursionError):
        return None


def disagrees(row, is_moving):
    """Whether the answer of an invalid/ file parts from the validator's."""
    if row.verdict in ("valid", "warned"):
        says_still = row.exit_code == EXIT_UNSUPPORTED and is_moving is False and row.issue in STILL_ISSUES
        return row.exit_code != EXIT_OK and not says_still
    if row.verdict == "error":
        return row.exit_code in (EXIT_OK, EXIT_UNSUPPORTED)
    return row.exit_code == EXIT_OK


def invalid_sentence(row, is_moving):
    """The sentence that a row needs, or "" when no rule has one."""
    if not disagrees(row, is_moving):
        return ""
    return INVALID.get(row.file) or (UNSUPPORTED.get(row.issue, "") if row.exit_code == EXIT_UNSUPPORTED else "")


def feature_sentence(row, readme_row):
    if row.exit_code == EXIT_OK:
        return ""
    if row.file in FEATURES_EXCEPTIONS:
        return FEATURES_EXCEPTIONS[row.file]
    for issue, pattern, sentence in FEATURES:
        if issue == row.issue and re.search(pattern, readme_row):
            return sentence
    return ""


def faults_of(row, exits, is_moving, is_invalid):
    """What is wrong with a row of a table, whatever the program does."""
    faults = []
    if row.exit_code not in (EXIT_OK, EXIT_MALFORMED, EXIT_UNSUPPORTED, EXIT_LIMIT):
        faults.append(f"expected exit code 0, 3, 5 or 6, found {row.exit_code}")
    if row.exit_code == EXIT_OK and row.issue != NOT_COUNTED or \
            row.exit_code != EXIT_OK and exits.get(row.issue) != row.exit_code:
        faults.append(f"{row.issue} does not go with exit code {row.exit_code}")
    if row.verdict == "valid" and row.exit_code == EXIT_MALFORMED:
        faults.append("the validator finds it valid, so it must not be refused as malformed")
    if row.exit_code == EXIT_OK and is_moving is False:
        faults.append("nothing in it moves, yet it bakes")
    if row.verdict == "valid" and is_moving is False and row.issue not in STILL_ISSUES:
        faults.append(f"nothing in it moves, expected E-GLB-NO-ANIMATION, found {row.issue}")
    needs_sentence = disagrees(row, is_moving) if is_invalid else row.exit_code != EXIT_OK
    if needs_sentence and not row.sentence:
        faults.append("expected a sentence that says why, found none")
    if row.sentence and not needs_sentence:
        faults.append("expected no sentence: there is nothing to explain")
    return faults
