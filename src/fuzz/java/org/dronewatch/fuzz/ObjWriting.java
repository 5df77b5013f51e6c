package org.dronewatch.fuzz;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * Random OBJ files of small solids and polygons, written in all the ways that the format allows, and in some that it
 * does not.
 */
final class ObjWriting {
    private static final List<String> UNKNOWN_LINES = List.of(
            "w 0 0 0",
            "x",
            "vertex 1 2 3",
            "face 1 2 3",
            "vp 0.1 0.2",
            "curv 0 1 1 2",
            "cstype bezier",
            "f2 1 2 3",
            "vx 9 9 9",
            "q 1 2 3 4",
            "end",
            "deg 3",
            "tv",
            "\u00A0v 5 5 50",
            "call x.obj",
            "fo 1 2 3");
    private static final List<String> HARMLESS_LINES = List.of(
            "# a comment",
            "",
            "   ",
            "\t",
            "o thing",
            "g a b c",
            "s off",
            "s 1",
            "vn 0 0 1",
            "vt 0.5 0.5",
            "l 1 2",
            "p 1",
            "usemtl a",
            "usemtl Stra\u00DFe",
            "g \u5BB6",
            "#");
    private static final List<String> WRONG_LINES = List.of(
            "v 1 2",
            "v",
            "v nan 0 0",
            "v 1e39 0 0",
            "v 1,5 2 3",
            "v 1 2 3 4 5 6 7 8 9",
            "f 1 2",
            "f",
            "f 0 1 2",
            "f 1 2 99999",
            "f -99 1 2",
            "f 1/ 2/ 3/",
            "f 1//2 3/4 5",
            "f 1 2 x",
            "f 1.5 2 3",
            "f 99999999999 1 2",
            "v 0x10 0 0",
            "v 1d 2f 3",
            "v \u0661 \u0662 \u0663",
            "f \u0661 \u0662 \u0663",
            "f 1 2 3 \\",
            "v 1 2 3 # \\",
            "v Infinity 0 0",
            "usemtl",
            "mtllib",
            "vt",
            "vn 1",
            "f 1\\2 3");

    private final Dice dice;
    private final StringBuilder text = new StringBuilder();
    private final String end;
    private final boolean polygons;
    private int vertices;

    private ObjWriting(Dice dice) {
        this.dice = dice;
        this.polygons = dice.oneIn(2);
        this.end = dice.pick("\n", "\n", "\n", "\r\n", "\r");
    }

    /** A random file. */
    static String file(Dice dice) {
        ObjWriting file = new ObjWriting(dice);
        if (dice.oneIn(6)) {
            file.text.append('\uFEFF');
        }
        int pieces = dice.between(1, 4);
        for (int i = 0; i < pieces; i++) {
            file.other();
            file.piece();
        }
        if (dice.oneIn(5)) {
            file.text.setLength(Math.max(0, file.text.length() - file.end.length()));
        }
        return file.text.toString();
    }

    private void line(String line) {
        text.append(dice.oneIn(12) ? dice.pick(" ", "\t", "   ") : "").append(line);
        text.append(dice.oneIn(12) ? dice.pick(" ", "\t", " # remark") : "").append(end);
    }

    private void other() {
        if (dice.oneIn(2)) {
            text.append(dice.pick(HARMLESS_LINES)).append(end);
        }
        if (dice.oneIn(5)) {
            text.append(dice.pick(UNKNOWN_LINES)).append(end);
        }
        if (dice.oneIn(12)) {
            text.append(dice.pick(WRONG_LINES)).append(end);
        }
    }

    private void piece() {
        List<double[]> corners = new ArrayList<>();
        List<int[]> faces = new ArrayList<>();
        switch (polygons ? dice.below(4) : dice.below(2)) {
            case 0 -> box(corners, faces);
            case 1 -> triangles(corners, faces);
            default -> polygon(corners, faces);
        }
        boolean facesFirst = dice.oneIn(10);
        if (facesFirst) {
            faces.forEach(face -> face(face, true, 0));
        }
        int decorated = dice.oneIn(3) ? dice.between(0, 2) : 3;
        for (double[] corner : corners) {
            line("v" + space() + number(corner[0]) + space() + number(corner[1]) + space() + number(corner[2])
                    + (decorated == 0 ? " 1.0" : decorated == 1 ? " 0.5 0.5 0.5" : ""));
            if (dice.oneIn(30)) {
                other();
            }
        }
        vertices += corners.size();
        if (!facesFirst) {
            boolean relative = dice.oneIn(4);
            faces.forEach(face -> face(face, !relative, corners.size()));
        }
    }

    /**
     * A face of corners numbered from 0 in its piece; absolute indices also serve if its vertices have not been written
     * yet.
     */
    private void face(int[] face, boolean absolute, int written) {
        StringBuilder line = new StringBuilder("f");
        for (int corner : face) {
            line.append(space());
            line.append(absolute ? vertices - written + corner + 1 : corner - written);
            if (absolute && dice.oneIn(60)) {
                line.append(" \\").append(end);
            }
        }
        line(line.toString());
    }

    private String space() {
        return dice.oneIn(20) ? dice.pick("  ", "\t", " \t ") : " ";
    }

    private String number(double value) {
        return switch (dice.below(8)) {
            case 0 -> String.format(Locale.ROOT, "%.3e", value).replace("e", dice.pick("e", "E"));
            case 1 -> (value >= 0 ? "+" : "") + value;
            case 2 -> value == Math.rint(value) ? Long.toString((long) value) + dice.pick("", ".", ".0") : "" + value;
            default -> "" + value;
        };
    }

    private void box(List<double[]> corners, List<int[]> faces) {
        double size = dice.between(1, 20);
        double[] from = {dice.between(-9, 9), dice.between(-9, 9), dice.between(-9, 9)};
        for (int i = 0; i < 8; i++) {
            corners.add(
                    new double[] {from[0] + size * (i & 1), from[1] + size * (i >> 1 & 1), from[2] + size * (i >> 2 & 1)
                    });
        }
        int[][] all = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
        faces.addAll(List.of(all));
    }

    private void triangles(List<double[]> corners, List<int[]> faces) {
        double scale = dice.pick(1.0, 1.0, 0.125, 1024.0, 1e-6, 1e6);
        int count = dice.between(1, 12);
        for (int i = 0; i < count; i++) {
            for (int k = 0; k < 3; k++) {
                corners.add(new double[] {
                    scale * dice.between(-8, 8), scale * dice.between(-8, 8), scale * dice.between(-8, 8)
                });
            }
            faces.add(dice.oneIn(12) ? new int[] {3 * i, 3 * i, 3 * i + 1} : new int[] {3 * i, 3 * i + 1, 3 * i + 2});
        }
    }

    /** A star around its centre in a plane across an axis, on a grid: mostly concave, never crossing itself. */
    private void polygon(List<double[]> corners, List<int[]> faces) {
        int n = dice.between(4, 14);
        int axis = dice.below(3);
        double height = dice.between(-5, 5);
        int[] face = new int[n];
        for (int i = 0; i < n; i++) {
            double angle = 2 * Math.PI * (i + dice.between(0.0, 0.8)) / n;
            double radius = dice.between(4, 64);
            double[] corner = new double[3];
            corner[axis] = height;
            corner[(axis + 1) % 3] = Math.rint(8 * radius * Math.cos(angle)) / 8;
            corner[(axis + 2) % 3] = Math.rint(8 * radius * Math.sin(angle)) / 8;
            corners.add(corner);
            face[i] = i;
        }
        faces.add(face);
    }
}
