package org.dronewatch.mesh.io;

import java.io.IOException;
import java.util.Locale;
import org.dronewatch.geometry.Ints;
import org.dronewatch.setting.Counted;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;

/**
 * Reads the statements of an OBJ file into a collector. Keywords may be in capitals. An invalid statement, or one whose
 * keyword the format does not have, is an {@link InputException} that names file and line.
 */
final class ObjParser {
    private static final int MAX_DIGITS = 9;
    private static final int LONGEST_EXCERPT = 40;

    /** From here on single precision loses a tenth of a millimetre, m. */
    private static final float FAR = 1000f;

    private final String file;
    private final ObjLines lines;
    private final ObjMeshCollector collector;
    private final Ints corners = new Ints();
    private final double[] coordinates = new double[3];
    private String line = "";
    private int next;

    ObjParser(String file, ObjLines lines, ObjMeshCollector collector) {
        this.file = file;
        this.lines = lines;
        this.collector = collector;
    }

    /** Reads to the end of the file. */
    void read() throws IOException {
        for (line = lines.readLine(); line != null; line = lines.readLine()) {
            next = 0;
            String word = token();
            if (!word.isEmpty() && word.charAt(0) != '#') {
                statement(word);
            }
        }
    }

    private void statement(String word) {
        String known = word.toLowerCase(Locale.ROOT);
        switch (known) {
            case "v" -> vertex();
            // "fo", a face outline, is what old files have for a face.
            case "f", "fo" -> face();
            case "usemtl" -> collector.useMaterial(rest());
            case "mtllib" -> collector.addLibrary(rest());
            default -> {
                if (!ObjWords.isSkipped(known)) {
                    throw wrong("unknown keyword " + quoted(word) + ": no statement of the OBJ format begins with it");
                }
                collector.skip(known);
            }
        }
    }

    /** Three coordinates; what may follow them, a weight or a colour, must be numbers and has no effect. */
    private void vertex() {
        int count = 0;
        for (String token = token(); !token.isEmpty(); token = token()) {
            double value = number(token);
            if (count < coordinates.length) {
                coordinates[count] = value;
            }
            count++;
        }
        if (count < coordinates.length) {
            throw wrong("vertex has " + Counted.of(count, "coordinate") + " but needs 3");
        }
        collector.addVertex(coordinates[0], coordinates[1], coordinates[2]);
    }

    /**
     * A number in single precision, which suffices near the origin; coordinates of national grids need double
     * precision.
     */
    private double number(String token) {
        try {
            float value = Float.parseFloat(token);
            return Math.abs(value) < FAR ? value : Double.parseDouble(token);
        } catch (NumberFormatException e) {
            throw new InputException(lines.at(file) + "not a number: " + quoted(token), e);
        }
    }

    private void face() {
        corners.clear();
        for (String token = token(); !token.isEmpty(); token = token()) {
            corners.add(corner(token));
        }
        collector.addFace(corners);
    }

    /** The vertex index of a corner such as {@code 3}, {@code -1}, {@code 3/1}, {@code 3//2} or {@code 3/1/2}. */
    private int corner(String token) {
        int first = token.indexOf('/');
        if (first < 0) {
            return index(token, token);
        }
        int second = token.indexOf('/', first + 1);
        // Texture coordinates and normals have no effect, but their indices must be valid.
        String texture = token.substring(first + 1, second < 0 ? token.length() : second);
        String normal = second < 0 ? "" : token.substring(second + 1);
        if (!texture.isEmpty()) {
            index(texture, token);
        }
        if (!normal.isEmpty()) {
            index(normal, token);
        }
        return index(token.substring(0, first), token);
    }

    private int index(String text, String corner) {
        int digits = text.startsWith("-") ? 1 : 0;
        for (int i = digits; i < text.length(); i++) {
            if (text.charAt(i) < '0' || text.charAt(i) > '9') {
                throw wrong("not a corner of a face: " + quoted(corner));
            }
        }
        if (text.length() == digits) {
            throw wrong("not a corner of a face: " + quoted(corner));
        }
        if (text.length() - digits > MAX_DIGITS) {
            throw wrong("index of more than " + MAX_DIGITS + " digits: " + quoted(corner));
        }
        return Integer.parseInt(text);
    }

    /** The next token of the line, without white space; empty at its end. */
    private String token() {
        while (next < line.length() && Character.isWhitespace(line.charAt(next))) {
            next++;
        }
        int start = next;
        while (next < line.length() && !Character.isWhitespace(line.charAt(next))) {
            next++;
        }
        return line.substring(start, next);
    }

    private String rest() {
        return line.substring(next).strip();
    }

    private InputException wrong(String what) {
        return new InputException(lines.at(file) + what);
    }

    private static String quoted(String text) {
        return "'" + PlainText.beginning(text, LONGEST_EXCERPT) + "'";
    }
}
