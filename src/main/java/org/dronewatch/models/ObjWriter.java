package org.dronewatch.models;

import java.util.List;

/**
 * Writes a {@link Mesh} as OBJ and MTL text that is identical byte for byte wherever and whenever it is written: fixed
 * decimals, line feeds, no dates, no negative zero.
 */
public final class ObjWriter {

    private ObjWriter() {}

    /** OBJ text; refers to {@code <name>.mtl}. */
    public static String obj(Mesh mesh) {
        StringBuilder out = new StringBuilder(mesh.vertices().size() * 64);
        appendHeader(out, mesh);
        out.append("mtllib ").append(mesh.name()).append(".mtl\n");
        for (Point p : mesh.vertices()) {
            out.append('v');
            for (double coordinate : new double[] {p.x(), p.y(), p.z()}) {
                out.append(' ');
                appendFixed(out, coordinate, mesh.decimals());
            }
            out.append('\n');
        }
        mesh.parts().forEach(part -> appendPart(out, part));
        return out.toString();
    }

    /** MTL text with the materials in the order of their first use. */
    public static String mtl(Mesh mesh) {
        StringBuilder out = new StringBuilder();
        appendHeader(out, mesh);
        for (Material material : mesh.materials()) {
            out.append("newmtl ").append(material.name()).append('\n');
            out.append("Kd");
            for (double shade : List.of(material.red(), material.green(), material.blue())) {
                out.append(' ');
                appendFixed(out, shade, 3);
            }
            out.append("\nKs 0.000 0.000 0.000\nd 1.000\nillum 1\n");
        }
        return out.toString();
    }

    private static void appendHeader(StringBuilder out, Mesh mesh) {
        out.append("# dronewatch ").append(mesh.name()).append(", metres, y up, north is -z; Apache-2.0\n");
    }

    private static void appendPart(StringBuilder out, Mesh.Part part) {
        out.append("o ").append(part.name()).append('\n');
        Material current = null;
        for (Mesh.Face face : part.faces()) {
            if (!face.material().equals(current)) {
                current = face.material();
                out.append("usemtl ").append(current.name()).append('\n');
            }
            out.append('f');
            face.corners().forEach(corner -> out.append(' ').append(corner + 1));
            out.append('\n');
        }
    }

    /** Works in whole units of the last decimal, so that no locale and no sign of zero can leak in. */
    static void appendFixed(StringBuilder out, double value, int decimals) {
        long scale = 1;
        for (int i = 0; i < decimals; i++) {
            scale *= 10;
        }
        long units = Math.round(value * scale);
        if (units < 0) {
            out.append('-');
        }
        out.append(Math.abs(units) / scale);
        if (decimals > 0) {
            String fraction = Long.toString(Math.abs(units) % scale);
            out.append('.').append("0".repeat(decimals - fraction.length())).append(fraction);
        }
    }
}
