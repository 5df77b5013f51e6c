package org.dronewatch.mesh.io;

import java.util.Set;

/** The keywords of those statements of the OBJ format that create no triangles here. */
final class ObjWords {
    /**
     * Statements without effect on where surfaces are: texture, normals, names, points, curves, how a surface is drawn.
     */
    private static final Set<String> WITHOUT_EFFECT = Set.of(
            "vt",
            "vn",
            "vp",
            "cstype",
            "deg",
            "bmat",
            "step",
            "p",
            "l",
            "curv",
            "curv2",
            "parm",
            "trim",
            "hole",
            "scrv",
            "sp",
            "end",
            "con",
            "g",
            "s",
            "mg",
            "o",
            "bevel",
            "c_interp",
            "d_interp",
            "lod",
            "usemap",
            "maplib",
            "shadow_obj",
            "trace_obj",
            "ctech",
            "stech",
            "cdc",
            "res");

    /** Statements that would add surfaces: from free forms, from another file, from a command's output. */
    private static final Set<String> OF_SURFACES = Set.of("surf", "bsp", "bzp", "cdp", "call", "csh");

    private ObjWords() {}

    /** Whether the format has such a statement, and it is skipped here. */
    static boolean isSkipped(String word) {
        return WITHOUT_EFFECT.contains(word) || isOfSurfaces(word);
    }

    /** Whether surfaces are missing where such a statement is skipped. */
    static boolean isOfSurfaces(String word) {
        return OF_SURFACES.contains(word);
    }
}
